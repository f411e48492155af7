#include <gtest/gtest.h>

#include "geometry/map.hpp"
#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

const std::string kGood = R"(name: nao
margin_m: 0.02
modes:
  upright: {body_m: {x: [-0.13, 0.13], y: [-0.2, 0.2], z: [0.0, 0.6]}, speed_mps: {forward: 0.068, left: 0.04}, turn_speed_radps: 0.17}
  crawl: {body_m: {x: [-0.3, 0.4], y: [-0.2, 0.2], z: [0.0, 0.2]}, speed_mps: {forward: 0.025}, turn_speed_radps: 0, drift_m_per_m: 0.02, step_over_m: 0.01}
switches:
  - {from: upright, to: crawl, duration_s: 8, displacement: {x_m: 0.3, y_m: 0.1, yaw_rad: 0.2}, body_m: {x: [-0.13, 0.7], y: [-0.3, 0.3], z: [0, 0.6]}}
  - {from: crawl, to: upright, duration_s: 12}
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("the test's file has no " + what);
  return text.replace(at, what.size(), by);
}

class RobotFile : public testing::Test {
 protected:
  Expected<Robot> read(const std::string& yaml) { return readRobot(scratch_.write("r.yaml", yaml)); }
  Scratch scratch_;
};

TEST_F(RobotFile, ModesKeepTheOrderOfTheFile) {
  const auto dut = read(kGood);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->name, "nao");
  EXPECT_EQ(dut->margin_m, 0.02);
  ASSERT_EQ(dut->modes.size(), 2u);
  const Mode upright{"upright", {{-0.13, 0.13}, {-0.2, 0.2}, {0.0, 0.6}}, {0.068, 0.0, 0.04, 0.0}, 0.17, 0.0,
                     0.0};
  const Mode crawl{"crawl", {{-0.3, 0.4}, {-0.2, 0.2}, {0.0, 0.2}}, {0.025, 0.0, 0.0, 0.0}, 0.0, 0.02, 0.01};
  EXPECT_EQ(dut->modes[0], upright);
  EXPECT_EQ(dut->modes[1], crawl);
}

TEST_F(RobotFile, SwitchesNameTheirModes) {
  const auto dut = read(kGood);
  ASSERT_TRUE(dut) << dut.error().message;
  ASSERT_EQ(dut->switches.size(), 2u);
  const Switch down{0, 1, 8.0, {0.3, 0.1, 0.2}, {{-0.13, 0.7}, {-0.3, 0.3}, {0.0, 0.6}}};
  EXPECT_EQ(dut->switches[0], down);
  const Switch& up = dut->switches[1];
  EXPECT_EQ(up.from, 1);
  EXPECT_EQ(up.to, 0);
  EXPECT_EQ(up.displacement, (Pose{}));
  EXPECT_EQ(up.body_m, (BodyBox{{-0.3, 0.4}, {-0.2, 0.2}, {0.0, 0.6}}))
      << "not given: the hull of both bodies";
}

TEST_F(RobotFile, TellsTheRobotsSenses) {
  const auto dut =
      read(kGood + "senses:\n  waist: {height_m: 0.3}\n  depth: {field_rad: 1.5, farthest_m: 3.0}\n");
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->senses.waist, LidarSense{0.3});
  EXPECT_EQ(dut->senses.head, std::nullopt);
  EXPECT_EQ(dut->senses.depth, (DepthSense{1.5, 3.0}));
  EXPECT_EQ(hashOf(*dut), hashOf(*read(kGood))) << "no plan depends on them";
}

TEST_F(RobotFile, RefusesSensesThatCannotBe) {
  for (const char* senses : {"  waist: {height_m: -0.1}\n", "  nose: {height_m: 0.1}\n", "  head: {}\n",
                             "  depth: {field_rad: 7.0, farthest_m: 3.0}\n",
                             "  depth: {field_rad: 1.0, farthest_m: 0.0}\n", "  waist: {height_m: high}\n"}) {
    const auto dut = read(kGood + "senses:\n" + senses);
    ASSERT_FALSE(dut) << senses;
    EXPECT_EQ(dut.error().code, ErrorCode::kInvalidRobot);
    EXPECT_NE(dut.error().message.find("r.yaml:"), std::string::npos) << dut.error().message;
  }
}

TEST_F(RobotFile, OneModeNeedsNoSwitches) {
  EXPECT_TRUE(
      read("name: a\nmargin_m: 0\nmodes:\n  walk: {body_m: {x: [0, 1], y: [0, 1], z: [0, 1]}, "
           "speed_mps: {forward: 1}, turn_speed_radps: 1}\n"));
}

TEST_F(RobotFile, WhatIsWrongIsToldWithFileLineAndKey) {
  const auto expect_refused = [&](const std::string& good, const std::string& bad,
                                  std::initializer_list<std::string> words) {
    const auto result = read(replaced(kGood, good, bad));
    EXPECT_TRUE(refusedNaming(result, {"r.yaml:"})) << bad;
    EXPECT_TRUE(refusedNaming(result, words)) << bad;
    if (!result) {
      EXPECT_EQ(result.error().code, ErrorCode::kInvalidRobot);
    }
  };
  expect_refused("name: nao\n", "", {":1:", "\"name\"", "missing"});
  expect_refused("margin_m: 0.02", "margin_m: -0.1", {":2:", "margin_m", "0 or more"});
  expect_refused("margin_m: 0.02", "margin: 0.02", {":2:", "\"margin\"", "margin_m"});
  expect_refused("margin_m: 0.02", "margin_m: .nan", {":2:", "margin_m", "finite"});
  expect_refused("x: [-0.13, 0.13]", "x: [0.13, -0.13]", {":4:", "modes.upright.body_m.x", "min below max"});
  expect_refused("x: [-0.13, 0.13]", "x: [0.13]", {":4:", "modes.upright.body_m.x", "list of 2"});
  expect_refused("x: [-0.13, 0.13], ", "", {":4:", "modes.upright.body_m", "\"x\"", "missing"});
  expect_refused("z: [0.0, 0.6]", "z: [-0.1, 0.6]", {":4:", "modes.upright", "body_m.z"});
  expect_refused("forward: 0.068", "ahead: 0.068",
                 {":4:", "speed_mps", "\"ahead\"", "forward, backward, left or right"});
  expect_refused("forward: 0.068", "forward: -1", {":4:", "forward", "between 0"});
  expect_refused("forward: 0.068", "forward: fast", {":4:", "modes.upright.speed_mps.forward", "a number"});
  expect_refused(", turn_speed_radps: 0.17", "", {":4:", "\"turn_speed_radps\"", "missing"});
  expect_refused("turn_speed_radps: 0.17", "turn_speed_radps: -1", {":4:", "turn_speed_radps"});
  expect_refused("drift_m_per_m: 0.02", "drift_m_per_m: -1", {":5:", "drift_m_per_m"});
  expect_refused("step_over_m: 0.01", "step_over_m: 0.5", {":5:", "step_over_m"});
  expect_refused("  crawl: {", "  upright: {", {":5:", "\"upright\"", "twice"});
  expect_refused("  crawl: {", "  \"a\\tb\": {", {":5:", "control characters"});
  expect_refused("from: crawl", "from: creep", {":8:", "switches[1].from", "\"creep\"", "upright or crawl"});
  expect_refused("from: crawl", "from: upright", {":8:", "itself"});
  expect_refused("from: crawl, to: upright", "from: upright, to: crawl", {":8:", "twice"});
  expect_refused("duration_s: 12", "duration_s: -12", {":8:", "duration_s"});
  expect_refused("{x_m: 0.3,", "{x: 0.3,", {":7:", "displacement", "\"x\""});
  expect_refused("z: [0, 0.6]", "z: [0, 0]", {":7:", "switches[0].body_m.z", "min below max"});
}

TEST_F(RobotFile, HasAtLeastOneModeAndNoMoreThanCanBeRanked) {
  EXPECT_TRUE(refusedNaming(read("name: a\nmargin_m: 0\nmodes: {}"), {"r.yaml:3:", "modes", "at least one"}));
  EXPECT_TRUE(
      refusedNaming(read("name: a\nmargin_m: 0\nmodes: [walk]"), {"r.yaml:3:", "modes", "a mapping"}));
  std::string many = "name: a\nmargin_m: 0\nmodes:\n";
  for (std::size_t i = 0; i <= kMaxModes; ++i)
    many += "  m" + std::to_string(i) +
            ": {body_m: {x: [0, 1], y: [0, 1], z: [0, 1]}, speed_mps: {forward: 1}, turn_speed_radps: 1}\n";
  EXPECT_TRUE(refusedNaming(read(many), {"r.yaml:9:", "6 modes", "at most 5"}));
}

TEST_F(RobotFile, WhatIsNoRobotIsRefused) {
  EXPECT_TRUE(refusedNaming(readRobot(scratch_.path("gone.yaml")), {"gone.yaml", "no such file"}));
  EXPECT_TRUE(refusedNaming(read("[1]"), {"r.yaml:1:", "a mapping"}));
  EXPECT_TRUE(refusedNaming(read(""), {"r.yaml:1:", "empty"}));
}

TEST(OurRobots, CanAllBeRead) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(UNDERWAY_SOURCE_DIR) / "robots")) {
    if (entry.path().extension() != ".yaml") continue;  // models for physics lie beside
    const auto robot = readRobot(entry.path());
    EXPECT_TRUE(robot) << robot.error().message;
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace underway
