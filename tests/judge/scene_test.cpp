#include "tests/judge/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/judge/robot_file.hpp"

namespace judge {
namespace {

const std::filesystem::path kProject = UNDERWAY_SOURCE_DIR;

Box boxAt(Vec3 center, Vec3 size, Vec3 rpy = {}) { return {"box", center, size, rpy}; }

/// A folder of files of one test, taken away again.
class Files {
 public:
  Files() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("underway_judge_") + test->name());
    std::filesystem::create_directories(folder_);
  }
  ~Files() { std::filesystem::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
};

bool isOccupied(const Scene& scene, Vec2 at) {
  return std::any_of(scene.boxes.begin(), scene.boxes.end(),
                     [&](const Box& box) { return distance(at, footprint(box, 0.0, 1.0)) == 0.0; });
}

TEST(Footprint, OfAnUprightBoxIsItsBase) {
  const Polygon base = footprint(boxAt({1.0, 2.0, 0.5}, {2.0, 1.0, 1.0}), 0.1, 0.2);
  EXPECT_EQ(base, (Polygon{{0.0, 1.5}, {2.0, 1.5}, {2.0, 2.5}, {0.0, 2.5}}));
}

TEST(Footprint, IsEmptyForWhatPassesOverTheSlab) {
  EXPECT_TRUE(footprint(boxAt({0.0, 0.0, 0.5}, {1.0, 1.0, 0.5}), 0.0, 0.2).empty());
}

TEST(Footprint, CountsABoxThatTouchesTheSlabFromAbove) {
  EXPECT_EQ(footprint(boxAt({0.0, 0.0, 0.5}, {1.0, 1.0, 0.5}), 0.0, 0.25).size(), 4U);
}

TEST(Footprint, OfARampIsOnlyItsLowPart) {
  // A thin plate pitched by 45 degrees: between 0 and 0.5 m it reaches 0.5 m along x.
  const Polygon low =
      footprint(boxAt({0.0, 0.0, 0.0}, {4.0, 1.0, 1e-9}, {0.0, -std::atan(1.0), 0.0}), 0.0, 0.5);
  const auto [left, right] =
      std::minmax_element(low.begin(), low.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  EXPECT_NEAR(left->x, 0.0, 1e-8);
  EXPECT_NEAR(right->x, 0.5, 1e-8);
}

TEST(LowestOver, IsTheUndersideOfATableAndNothingBesideIt) {
  const Box top = boxAt({0.0, 0.0, 0.725}, {1.0, 1.0, 0.05});
  EXPECT_DOUBLE_EQ(*lowestOver(top, placed(Pose{}, Rect{0.2, 0.9, 0.0, 0.1}), 0.5), 0.70);
  EXPECT_FALSE(lowestOver(top, placed(Pose{}, Rect{0.6, 0.9, 0.0, 0.1}), 0.5));
}

TEST(LowestOver, OfASlopeIsItsHeightAtTheNearEdge) {
  const Box slope = boxAt({0.0, 0.0, 1.0}, {4.0, 4.0, 1e-9}, {0.0, -std::atan(0.5), 0.0});  // z = 1 + x / 2
  EXPECT_NEAR(*lowestOver(slope, placed(Pose{}, Rect{-0.2, 0.4, -0.1, 0.1}), 0.5), 0.9, 1e-8);
}

TEST(ReadScene, TurnsAndPlacesTheCellsOfAMapByItsOrigin) {
  const Files files;
  files.write("two.pgm", "P2\n# two rows\n2 2\n255\n0 254\n254 254\n");
  const auto map = files.write("two.yaml",
                               "image: two.pgm\nresolution: 1.0\norigin: [10.0, 20.0, 1.5707963267948966]\n"
                               "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const Scene scene = readScene(map);
  // The black pixel is the upper left one: 0..1 along the map's x, 1..2 along its y, which looks left.
  EXPECT_TRUE(isOccupied(scene, {8.5, 20.5}));
  EXPECT_FALSE(isOccupied(scene, {9.5, 20.5}));
  EXPECT_FALSE(isOccupied(scene, {8.5, 21.5}));
}

TEST(ReadScene, TakesUnknownCellsForObstaclesUnlessToldOtherwise) {
  const Files files;
  files.write("grey.pgm", std::string("P5\n3 1\n255\n") + '\0' + '\xCD' + '\xFE');
  const auto map = files.write("grey.yaml",
                               "image: grey.pgm\nresolution: 1.0\norigin: [0, 0, 0]\nnegate: 0\n"
                               "occupied_thresh: 0.65\nfree_thresh: 0.1\n");
  EXPECT_TRUE(isOccupied(readScene(map), {1.5, 0.5}));
  EXPECT_FALSE(isOccupied(readScene(map, Unknown::kFree), {1.5, 0.5}));
  EXPECT_TRUE(isOccupied(readScene(map, Unknown::kFree), {0.5, 0.5}));
  EXPECT_FALSE(isOccupied(readScene(map), {2.5, 0.5}));
}

TEST(ReadScene, NegateTurnsWhiteIntoWalls) {
  const Files files;
  files.write("deep.pgm", "P2 2 1 65535 0 65535");
  const auto map = files.write("deep.yaml",
                               "image: deep.pgm\nresolution: 1.0\norigin: [0, 0, 0]\nnegate: 1\n"
                               "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_FALSE(isOccupied(readScene(map), {0.5, 0.5}));
  EXPECT_TRUE(isOccupied(readScene(map), {1.5, 0.5}));
}

TEST(ReadScene, RefusesATruncatedImage) {
  const Files files;
  files.write("short.pgm", "P5\n3 3\n255\nab");
  const auto map = files.write("short.yaml",
                               "image: short.pgm\nresolution: 1.0\norigin: [0, 0, 0]\nnegate: 0\n"
                               "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_THROW((void)readScene(map), InputError);
}

TEST(ReadScene, ReadsEveryMapOfOurs) {
  std::size_t maps = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kProject / "maps")) {
    if (entry.path().extension() != ".yaml") continue;
    const Scene scene = readScene(entry.path());
    EXPECT_EQ(scene.name, entry.path().stem().string());
    EXPECT_GE(scene.boxes.size(), 4U) << entry.path();
    ++maps;
  }
  EXPECT_GE(maps, 12U);
}

TEST(ReadScene, PutsAMapServerMapUnderAScenario) {
  const Scene scene = readScene(kProject / "maps/office.yaml");
  EXPECT_TRUE(isOccupied(scene, {-0.95, 0.0}));  // the drawn west wall
  EXPECT_FALSE(isOccupied(scene, {1.0, 0.0}));
  EXPECT_TRUE(isOccupied(scene, {6.6, -1.6}));  // the corner nobody has seen
}

/// A map_server map of 10 x 10 cells, turned by its origin, with the cells that map_server's own test
/// expects.
TEST(ReadScene, FindsTheCellsThatMapServersOwnTestExpects) {
  const std::filesystem::path map = kProject / "../shared/maps/maps2d/map_server_test/testmap.yaml";
  if (!std::filesystem::exists(map)) GTEST_SKIP() << "NOT TESTED: " << map << " is not there";
  std::size_t cells = 0;
  for (const Box& box : readScene(map).boxes)
    cells += static_cast<std::size_t>(std::lround(box.size_m.x / 0.1));
  EXPECT_EQ(cells, 29U);
}

TEST(ReadRobotFile, ReadsEveryRobotOfOurs) {
  for (const char* name : {"nao", "nao_obb_paper", "tall_biped"}) {
    const RobotFile robot = readRobotFile(kProject / "robots" / (std::string(name) + ".yaml"));
    EXPECT_EQ(robot.name, name);
    EXPECT_GE(robot.modes.size(), 2U);
    EXPECT_GE(robot.switches.size(), 2U);
  }
}

TEST(ReadRobotFile, ASwitchWithoutABodyCoversBothModes) {
  const RobotFile robot = readRobotFile(kProject / "robots/tall_biped.yaml");
  const Switch* down = robot.findSwitch("upright", "stooped");
  ASSERT_NE(down, nullptr);
  EXPECT_EQ(down->body.footprint.x_min, -0.30);
  EXPECT_EQ(down->body.footprint.x_max, 0.50);
  EXPECT_EQ(down->body.height_m, 1.20);
}

}  // namespace
}  // namespace judge
