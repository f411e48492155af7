#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/grid.hpp"
#include "tests/geometry/read/sample_images.hpp"
#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

using namespace std::string_literals;

const std::string kGood =
    "image: map.pgm\nresolution: 0.5\norigin: [1.0, 2.0, 0.25]\nnegate: 0\noccupied_thresh: "
    "0.65\nfree_thresh: 0.196\n";
const std::string kPixels =
    "\x00\xcd\xff\xff\xff\x00"s;  // 3 x 2: occupied, unknown, free over free, free, occupied

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("the test's file has no " + what);
  return text.replace(at, what.size(), by);
}

class MapServer : public testing::Test {
 protected:
  MapServer() { scratch_.write("map.pgm", pgmOf(3, 2, kPixels)); }
  Expected<Map> read(const std::string& yaml, const MapOptions& options = {}) {
    return readMap(scratch_.write("map.yaml", yaml), options);
  }
  Scratch scratch_;
};

TEST_F(MapServer, RowZeroOfTheImageIsTheTopRowOfTheGrid) {
  const auto dut = readGrid(scratch_.write("map.yaml", kGood));
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->width, 3u);
  EXPECT_EQ(dut->height, 2u);
  EXPECT_EQ(dut->resolution_m, 0.5);
  EXPECT_EQ(dut->origin, (Pose{1.0, 2.0, 0.25}));
  EXPECT_EQ(dut->at(2, 0), Cell::kOccupied);
  EXPECT_EQ(dut->at(0, 0), Cell::kFree);
  EXPECT_EQ(dut->at(0, 1), Cell::kOccupied);
  EXPECT_EQ(dut->at(1, 1), Cell::kUnknown);
}

TEST_F(MapServer, TheWorldHasWallsWithinTheImagesBounds) {
  const auto dut = read(kGood);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.name(), "map");
  EXPECT_EQ(dut->world.floorZ(), 0.0);
  EXPECT_EQ(dut->world.bounds(), (Bounds{{1.0, 2.0, 0.25}, 1.5, 1.0}));
  ASSERT_EQ(dut->world.obstacles().size(), 2u);
  EXPECT_EQ(dut->world.obstacles()[0].id, "wall_0_1");
  EXPECT_EQ(dut->world.obstacles()[0].box.size_m, (Vec3{1.0, 0.5, 10.0}));
  EXPECT_EQ(dut->world.obstacles()[0].box.center_m.z, 5.0);
  EXPECT_EQ(dut->world.obstacles()[1].id, "wall_2_0");
  EXPECT_TRUE(dut->queries.empty());
}

TEST_F(MapServer, UnknownCellsMayBeTakenForFreeAndWallsMayBeLower) {
  MapOptions options;
  options.unknown = Unknown::kFree;
  options.wall_height_m = 2.5;
  const auto dut = read(kGood, options);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.obstacles()[1].box.size_m, (Vec3{0.5, 0.5, 2.5}));
}

TEST_F(MapServer, KeysOfOtherProgramsAndQuotedTextAreFine) {
  EXPECT_TRUE(read(kGood + "mode: \"trinary\"\nspeed_limit: {a: [1, 2]}\n"));
  EXPECT_TRUE(read(replaced(kGood, "negate: 0", "negate: false")));
}

TEST_F(MapServer, NegateAndModeAreUsed) {
  const auto cell = [&](const std::string& yaml) {
    return readGrid(scratch_.write("map.yaml", yaml))->at(2, 0);
  };
  EXPECT_EQ(cell(kGood), Cell::kOccupied);
  EXPECT_EQ(cell(replaced(kGood, "negate: 0", "negate: 1")), Cell::kFree);
  EXPECT_EQ(cell(kGood + "mode: raw\n"), Cell::kFree);
}

TEST_F(MapServer, BadNumbersAreRefusedWithFileLineAndKey) {
  const auto expect_refused = [&](const std::string& good, const std::string& bad,
                                  std::initializer_list<std::string> words) {
    const auto result = read(replaced(kGood, good, bad));
    EXPECT_TRUE(refusedNaming(result, {"map.yaml:"})) << bad;
    EXPECT_TRUE(refusedNaming(result, words)) << bad;
    if (!result) {
      EXPECT_EQ(result.error().code, ErrorCode::kInvalidMap);
    }
  };
  expect_refused("resolution: 0.5", "resolution: 0", {"map.yaml:2:", "resolution", "above 0"});
  expect_refused("resolution: 0.5", "resolution: -0.1", {":2:", "resolution", "above 0"});
  expect_refused("resolution: 0.5", "resolution: .inf", {":2:", "resolution", "finite"});
  expect_refused("resolution: 0.5", "resolution: nan", {":2:", "resolution", "finite"});
  expect_refused("resolution: 0.5", "resolution: 1e999", {":2:", "resolution", "beyond"});
  expect_refused("resolution: 0.5", "resolution: fine", {":2:", "resolution", "a number", "fine"});
  expect_refused("resolution: 0.5\n", "", {":1:", "resolution", "missing"});
  expect_refused("resolution: 0.5", "resolution: 90000", {"100 km"});
  expect_refused("[1.0, 2.0, 0.25]", "[1.0, 2.0]", {":3:", "origin", "list of 3"});
  expect_refused("[1.0, 2.0, 0.25]", "[1.0, x, 0.25]", {":3:", "origin[1]", "a number"});
  expect_refused("[1.0, 2.0, 0.25]", "[1e30, 2.0, 0.25]", {"corner", "100 km"});
  expect_refused("occupied_thresh: 0.65", "occupied_thresh: 1.5",
                 {":5:", "occupied_thresh", "between 0 and 1"});
  expect_refused("free_thresh: 0.196", "free_thresh: -1", {":6:", "free_thresh", "between 0 and 1"});
  expect_refused("free_thresh: 0.196", "free_thresh: 0.7", {":6:", "free_thresh", "swapped"});
  expect_refused("negate: 0", "negate: maybe", {":4:", "negate", "true or false"});
  expect_refused("negate: 0", "negate: 0\nmode: fancy", {":5:", "mode", "trinary, scale or raw"});
  expect_refused("image: map.pgm", "image: gone.pgm", {":1:", "gone.pgm", "no such file"});
  expect_refused("image: map.pgm", "image: [a]", {":1:", "image", "text"});
  expect_refused("negate: 0", "negate: 0\nnegate: 1", {":5:", "negate", "twice"});
}

TEST_F(MapServer, ADamagedImageIsRefusedWithItsOwnName) {
  scratch_.write("map.pgm", "P5 3 2 255\nab");
  EXPECT_TRUE(refusedNaming(read(kGood), {"map.pgm", "cut short"}));
  scratch_.write("map.pgm", "GIF89a......");
  EXPECT_TRUE(refusedNaming(read(kGood), {"map.pgm", "GIF", "convert"}));
}

TEST_F(MapServer, TheContentOfAnImageDecidesNotItsName) {
  scratch_.write("map.pgm", pngOf({3, 2, 8, 0}, {kPixels.substr(0, 3), kPixels.substr(3)}));
  const auto dut = read(kGood);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.obstacles().size(), 2u);
}

TEST_F(MapServer, OptionsThatAreForAnImageAreRefusedForAYaml) {
  MapOptions options;
  options.free_thresh = 0.1;
  EXPECT_TRUE(refusedNaming(read(kGood, options), {"map.yaml", "--free-thresh", "leave it out"}));
  options = {};
  options.resolution_m = 0.1;
  EXPECT_TRUE(refusedNaming(read(kGood, options), {"map.yaml", "--resolution-m"}));
}

TEST_F(MapServer, AWallNeedsAHeight) {
  for (const double height_m : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    MapOptions options;
    options.wall_height_m = height_m;
    EXPECT_TRUE(refusedNaming(read(kGood, options), {"map.yaml", "height"}));
  }
}

TEST_F(MapServer, AnImageAloneIsGivenItsNumbersByOptions) {
  MapOptions options;
  EXPECT_TRUE(refusedNaming(readMap(scratch_.path("map.pgm"), options), {"map.pgm", "--resolution-m"}));
  options.resolution_m = 0.5;
  const auto dut = readMap(scratch_.path("map.pgm"), options);
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.bounds(), (Bounds{{0.0, 0.0, 0.0}, 1.5, 1.0}));
  EXPECT_EQ(dut->world.obstacles().size(), 2u);
}

TEST_F(MapServer, BadOptionsAreRefusedByTheirFlags) {
  const auto read_with = [&](double resolution_m, double occupied, double free) {
    MapOptions options;
    options.resolution_m = resolution_m;
    options.occupied_thresh = occupied;
    options.free_thresh = free;
    return readMap(scratch_.path("map.pgm"), options);
  };
  EXPECT_TRUE(read_with(0.5, 0.65, 0.65));
  EXPECT_TRUE(refusedNaming(read_with(0.0, 0.65, 0.2), {"map.pgm", "--resolution-m", "above 0"}));
  EXPECT_TRUE(refusedNaming(read_with(std::nan(""), 0.65, 0.2), {"map.pgm", "--resolution-m"}));
  EXPECT_TRUE(refusedNaming(read_with(0.5, 1.1, 0.2), {"map.pgm", "--occupied-thresh"}));
  EXPECT_TRUE(refusedNaming(read_with(0.5, 0.65, std::nan("")), {"map.pgm", "--free-thresh"}));
  EXPECT_TRUE(refusedNaming(read_with(0.5, 0.2, 0.65), {"map.pgm", "--free-thresh", "swapped"}));
}

}  // namespace
}  // namespace underway
