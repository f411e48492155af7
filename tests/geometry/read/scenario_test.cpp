#include <gtest/gtest.h>

#include "geometry/map.hpp"
#include "tests/geometry/read/sample_images.hpp"
#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

const std::string kGood = R"(name: room
floor_z_m: 0.1
bounds_m: {min: [-1.0, 0.0], max: [6.0, 4.0]}
obstacles:
  - {id: wall, center_m: [2.0, 0.9, 0.5], size_m: [0.1, 1.8, 1.0], rpy_rad: [0.1, 0.2, 0.3]}
  - {id: table, center_m: [4.0, 2.0, 0.65], size_m: [0.4, 0.8, 0.7]}
queries:
  - {name: under, start: [0.6, 2.0, 0.5], start_mode: frontal, goal: [5.4, 2.0, 0.1], goal_mode: crawl, expect: no_path_exists, must_use: [frontal, crawl]}
  - {name: beside, start: [0.6, 2.0, 0.0], goal: [5.4, 2.0]}
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("the test's file has no " + what);
  return text.replace(at, what.size(), by);
}

class Scenario : public testing::Test {
 protected:
  Expected<Map> read(const std::string& yaml, const MapOptions& options = {}) {
    return readMap(scratch_.write("s.yaml", yaml), options);
  }
  Scratch scratch_;
};

TEST_F(Scenario, GivesTheWorldItDescribes) {
  const auto dut = read(kGood);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.name(), "room");
  EXPECT_EQ(dut->world.floorZ(), 0.1);
  EXPECT_EQ(dut->world.bounds(), (Bounds{{-1.0, 0.0, 0.0}, 7.0, 4.0}));
  const std::vector<Obstacle> expected{{"table", {{4.0, 2.0, 0.65}, {0.4, 0.8, 0.7}, {}}},
                                       {"wall", {{2.0, 0.9, 0.5}, {0.1, 1.8, 1.0}, {0.1, 0.2, 0.3}}}};
  const Obstacles& dut_obstacles = dut->world.obstacles();
  EXPECT_EQ(std::vector<Obstacle>(dut_obstacles.begin(), dut_obstacles.end()), expected);
}

TEST_F(Scenario, GivesItsQueries) {
  const auto dut = read(kGood);
  ASSERT_TRUE(dut) << dut.error().message;
  ASSERT_EQ(dut->queries.size(), 2u);
  const Query& under = dut->queries[0];
  EXPECT_EQ(under.name, "under");
  EXPECT_EQ(under.start, (Pose{0.6, 2.0, 0.5}));
  EXPECT_EQ(under.start_mode, "frontal");
  EXPECT_EQ(under.goal, (Point{5.4, 2.0}));
  EXPECT_EQ(under.goal_yaw, 0.1);
  EXPECT_EQ(under.goal_mode, "crawl");
  EXPECT_EQ(under.expect, "no_path_exists");
  EXPECT_EQ(under.must_use, (std::vector<std::string>{"frontal", "crawl"}));
  const Query& beside = dut->queries[1];
  EXPECT_EQ(beside.goal_yaw, std::nullopt);
  EXPECT_EQ(beside.start_mode, "");
  EXPECT_EQ(beside.goal_mode, "");
  EXPECT_EQ(beside.expect, "ok");
}

TEST_F(Scenario, NameFloorObstaclesAndQueriesMayBeLeftOut) {
  const auto dut = read("bounds_m: {min: [0, 0], max: [1, 1]}");
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.name(), "s");
  EXPECT_EQ(dut->world.floorZ(), 0.0);
  EXPECT_TRUE(dut->world.obstacles().empty());
}

TEST_F(Scenario, WhatIsWrongIsToldWithFileLineAndKey) {
  const auto expect_refused = [&](const std::string& good, const std::string& bad,
                                  std::initializer_list<std::string> words) {
    const auto result = read(replaced(kGood, good, bad));
    EXPECT_TRUE(refusedNaming(result, {"s.yaml"})) << bad;
    EXPECT_TRUE(refusedNaming(result, words)) << bad;
    if (!result) {
      EXPECT_EQ(result.error().code, ErrorCode::kInvalidMap);
    }
  };
  expect_refused("obstacles:", "obstacle:", {"s.yaml:4:", "\"obstacle\"", "did you mean \"obstacles\"?"});
  expect_refused("floor_z_m: 0.1", "floor_z_m: .nan", {":2:", "floor_z_m", "finite"});
  expect_refused("floor_z_m: 0.1", "floor_z_m: 1e6", {":2:", "floor_z_m", "100 km"});
  expect_refused("max: [6.0, 4.0]", "max: [6.0, 0.0]", {":3:", "bounds_m.max", "above min"});
  expect_refused("max: [6.0, 4.0]", "max: [6.0]", {":3:", "bounds_m.max", "list of 2"});
  expect_refused("max: [6.0, 4.0]", "top: [6.0, 4.0]", {":3:", "bounds_m", "\"top\""});
  expect_refused("bounds_m: {min: [-1.0, 0.0], max: [6.0, 4.0]}\n", "", {":1:", "bounds_m", "missing"});
  expect_refused("id: table", "id: wall", {":6:", "obstacles[1].id", "\"wall\"", "twice"});
  expect_refused("id: table, ", "", {":6:", "obstacles[1]", "\"id\"", "missing"});
  expect_refused("id: table", "id: [table]", {":6:", "obstacles[1].id", "text"});
  expect_refused("size_m: [0.4, 0.8, 0.7]", "size_m: [0.4, 0.0, 0.7]",
                 {":6:", "obstacles[1].size_m", "above 0"});
  expect_refused("size_m: [0.4, 0.8, 0.7]", "size_m: [0.4, -1, 0.7]", {":6:", "size_m", "above 0"});
  expect_refused("size_m: [0.4, 0.8, 0.7]", "size: [0.4, 0.8, 0.7]", {":6:", "\"size\""});
  expect_refused("center_m: [4.0, 2.0, 0.65]", "center_m: [4.0, 2.0]", {":6:", "center_m", "list of 3"});
  expect_refused("center_m: [4.0, 2.0, 0.65]", "center_m: [4.0, 2.0, 2e5]", {":6:", "center_m", "100 km"});
  expect_refused("rpy_rad: [0.1, 0.2, 0.3]", "rpy_rad: [0.1, .inf, 0.3]", {":5:", "rpy_rad[1]", "finite"});
  expect_refused("rpy_rad: [0.1, 0.2, 0.3]", "rpy_rad: [0.1, 1e9, 0.3]", {"\"wall\"", "rpy_rad"});
  expect_refused("name: beside", "name: under", {":9:", "queries[1].name", "\"under\"", "twice"});
  expect_refused("goal: [5.4, 2.0]", "goal: [5.4]", {":9:", "queries[1].goal", "2 to 3"});
  expect_refused("start: [0.6, 2.0, 0.0]", "start: [0.6, 2.0]", {":9:", "queries[1].start", "list of 3"});
  expect_refused("expect: no_path_exists", "expect: no_path",
                 {":8:", "queries[0].expect", "no_path_exists", "\"no_path\""});
  expect_refused("must_use: [frontal, crawl]", "must_use: frontal", {":8:", "must_use", "a list"});
  expect_refused("must_use: [frontal, crawl]", "must_use: [[]]", {":8:", "must_use[0]", "text"});
  expect_refused("name: room", "name: room\nname: hall", {":2:", "\"name\"", "twice"});
}

TEST_F(Scenario, WhatIsNoMapAtAllIsToldWhatWasExpected) {
  EXPECT_TRUE(refusedNaming(read("colour: red"), {"s.yaml:1:", "bounds_m", "resolution"}));
  EXPECT_TRUE(refusedNaming(read("name: nao\nmodes: {}"), {"s.yaml", "robot"}));
  EXPECT_TRUE(refusedNaming(read("- 1"), {"s.yaml:1:", "a mapping", "a list"}));
  EXPECT_TRUE(refusedNaming(read("hello"), {"s.yaml:1:", "a mapping"}));
  EXPECT_TRUE(refusedNaming(read(""), {"s.yaml:1:", "empty"}));
  EXPECT_TRUE(refusedNaming(readMap(scratch_.path("gone.yaml")), {"gone.yaml", "no such file"}));
}

TEST_F(Scenario, ImageOptionsAreRefused) {
  MapOptions options;
  options.origin = Pose{};
  EXPECT_TRUE(refusedNaming(read(kGood, options), {"s.yaml", "--origin"}));
}

class ScenarioWithFloor : public Scenario {
 protected:
  ScenarioWithFloor() {
    scratch_.write("floor.pgm", pgmOf(2, 1, std::string("\x00\xff", 2)));
    scratch_.write("floor.yaml",
                   "image: floor.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  }
};

TEST_F(ScenarioWithFloor, ItsCellsStandOnTheScenariosFloorAtTheGivenHeight) {
  const auto dut = read("floor_z_m: 1.0\nmap: {image: floor.yaml, height_m: 2.0}");
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.bounds(), (Bounds{{1.0, 2.0, 0.0}, 1.0, 0.5}));
  ASSERT_EQ(dut->world.obstacles().size(), 1u);
  EXPECT_EQ(dut->world.obstacles()[0].box.center_m, (Vec3{1.25, 2.25, 2.0}));
  EXPECT_EQ(dut->world.obstacles()[0].box.size_m, (Vec3{0.5, 0.5, 2.0}));
}

TEST_F(ScenarioWithFloor, GivenBoundsAndObstaclesAreKept) {
  const auto dut = read(kGood + "map: {image: floor.yaml, height_m: 2.0}");
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.bounds().width_m, 7.0);
  EXPECT_EQ(dut->world.obstacles().size(), 3u);
}

TEST_F(ScenarioWithFloor, WhatIsWrongWithItIsTold) {
  EXPECT_TRUE(refusedNaming(read("map: {image: gone.yaml, height_m: 2.0}"),
                            {"s.yaml:1:", "gone.yaml", "no such file"}));
  EXPECT_TRUE(
      refusedNaming(read("map: {image: floor.pgm, height_m: 2.0}"), {"s.yaml:1:", "floor.pgm", "YAML"}));
  EXPECT_TRUE(refusedNaming(read("map: {image: s.yaml, height_m: 2.0}"), {"s.yaml:1:", "resolution"}));
  EXPECT_TRUE(refusedNaming(read("map: {image: floor.yaml}"), {"s.yaml:1:", "height_m", "missing"}));
  EXPECT_TRUE(
      refusedNaming(read("map: {image: floor.yaml, height_m: 0}"), {"s.yaml:1:", "height_m", "above 0"}));
}

TEST(OurScenarios, CanAllBeRead) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(UNDERWAY_SOURCE_DIR) / "maps")) {
    if (entry.path().extension() != ".yaml") continue;
    const auto map = readMap(entry.path());
    EXPECT_TRUE(map) << map.error().message;
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace underway
