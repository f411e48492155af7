#include "geometry/robot.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

/// What checkedRobot says of a sound robot that one change has spoilt.
std::string refusalAfter(const std::function<void(Robot&)>& spoil) {
  Robot robot = *test::smallRobot();
  spoil(robot);
  const auto dut = checkedRobot(robot);
  if (dut) return "accepted";
  EXPECT_EQ(dut.error().code, ErrorCode::kInvalidRobot);
  return dut.error().message;
}

TEST(CheckedRobot, RefusesEachFaultWithItsPlace) {
  const auto says = [](const std::string& sentence, const char* part) {
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  };
  says(refusalAfter([](Robot& r) { r.name.clear(); }), "no name");
  says(refusalAfter([](Robot& r) { r.margin_m = -0.01; }), "margin_m");
  says(refusalAfter([](Robot& r) {
         r.modes.clear();
         r.switches.clear();
       }),
       "no modes");
  says(refusalAfter([](Robot& r) { r.modes[1].name = "walk"; }), "\"walk\" is given twice");
  says(refusalAfter([](Robot& r) { r.modes[2].body_m.x = {0.3, -0.3}; }), "mode \"crawl\": body_m.x");
  says(refusalAfter([](Robot& r) { r.modes[0].body_m.z = {-0.1, 0.5}; }), "body_m.z");
  says(refusalAfter([](Robot& r) { r.modes[0].speed_mps[0] = -1.0; }), "speed_mps.forward");
  says(refusalAfter([](Robot& r) { r.modes[0].turn_speed_radps = -0.1; }), "turn_speed_radps");
  says(refusalAfter([](Robot& r) { r.modes[2].drift_m_per_m = 2.0; }), "drift_m_per_m");
  says(refusalAfter([](Robot& r) { r.modes[2].step_over_m = 0.3; }), "step_over_m");
  says(refusalAfter([](Robot& r) { r.switches[0].duration_s = -1.0; }),
       "switch walk -> sidestep: duration_s");
  says(refusalAfter([](Robot& r) { r.switches[2].body_m.x = {-0.13, 0.29}; }), "cover the whole motion");
  says(refusalAfter([](Robot& r) { r.switches[2].body_m.z.max = 0.5; }), "cover the whole motion");
  says(refusalAfter([](Robot& r) { r.switches[0].to = 9; }), "does not exist");
  says(refusalAfter([](Robot& r) { r.switches[1] = r.switches[0]; }), "walk -> sidestep is given twice");
  says(refusalAfter([](Robot& r) { r.modes.resize(kMaxModes + 1, r.modes[0]); }), "at most 5");
}

TEST(CheckedRobot, GivesASwitchWithoutABodyTheHullOfBothModes) {
  Robot robot = *test::smallRobot();
  robot.switches = {{0, 2, 8.0, {0.30, 0.0, 0.0}, {}}};
  const BodyBox dut = checkedRobot(robot)->switches[0].body_m;
  EXPECT_NEAR(dut.x.min, -0.13, 1e-12);
  EXPECT_NEAR(dut.x.max, 0.66, 1e-12);
  EXPECT_NEAR(dut.z.max, 0.585, 1e-12);
}

TEST(HashOfRobot, TellsEveryNumberApart) {
  const Robot robot = *test::smallRobot();
  Robot slower = robot;
  slower.modes[2].speed_mps[0] = 0.024;
  Robot longer = robot;
  longer.switches[2].displacement.x = 0.31;
  EXPECT_NE(hashOf(robot), hashOf(slower));
  EXPECT_NE(hashOf(robot), hashOf(longer));
  EXPECT_EQ(hashOf(robot), hashOf(*test::smallRobot()));
}

}  // namespace
}  // namespace underway
