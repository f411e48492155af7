// Maps of real buildings. They stay where they are, beside the project; without them these tests say so and
// skip.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geometry/grid.hpp"
#include "geometry/read/walls.hpp"
#include "tests/geometry/read/scratch.hpp"

namespace underway {
namespace {

const std::filesystem::path kMaps =
    std::filesystem::path(UNDERWAY_SOURCE_DIR) / ".." / "shared" / "maps" / "maps2d";

class PublicMaps : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(kMaps)) GTEST_SKIP() << "NOT TESTED: no public maps in " << kMaps;
  }
};

struct Share {
  double per_cent;
  double tolerance;  ///< half a unit of the last digit that is documented
};

/// What the list of these maps says of one: size, and the share of each kind of cell.
struct Facts {
  std::string file;
  std::uint32_t width;
  std::uint32_t height;
  Share free;
  Share occupied;
  Share unknown;
};

MapOptions imageOptions(double resolution_m) {
  MapOptions options;
  options.resolution_m = resolution_m;
  return options;
}

double perCentOf(const Grid& grid, Cell kind) {
  const auto count = std::count(grid.cells.begin(), grid.cells.end(), kind);
  return 100.0 * static_cast<double>(count) / static_cast<double>(grid.cells.size());
}

void expectFacts(const Facts& facts, const MapOptions& options = {}) {
  SCOPED_TRACE(facts.file);
  const auto grid = readGrid(kMaps / facts.file, options);
  ASSERT_TRUE(grid) << grid.error().message;
  EXPECT_EQ(grid->width, facts.width);
  EXPECT_EQ(grid->height, facts.height);
  EXPECT_NEAR(perCentOf(*grid, Cell::kFree), facts.free.per_cent, facts.free.tolerance);
  EXPECT_NEAR(perCentOf(*grid, Cell::kOccupied), facts.occupied.per_cent, facts.occupied.tolerance);
  EXPECT_NEAR(perCentOf(*grid, Cell::kUnknown), facts.unknown.per_cent, facts.unknown.tolerance);
}

/// One decimal, two decimals.
Share tenths(double per_cent) { return {per_cent, 0.0501}; }
Share hundredths(double per_cent) { return {per_cent, 0.00501}; }

TEST_F(PublicMaps, HaveTheDocumentedSizesAndShares) {
  expectFacts(
      {"willow_0.10/willow-2010-02-18-0.10.yaml", 566, 608, tenths(31.7), hundredths(0.16), tenths(68.1)});
  expectFacts({"utexas_gdc_3ne/3ne.yaml", 1857, 573, tenths(42.9), hundredths(3.20), tenths(53.9)});
  expectFacts({"gt_rail/ilab.yaml", 200, 300, tenths(57.5), hundredths(6.19), tenths(36.3)});
  expectFacts({"gt_rail/rail_lab.yaml", 144, 131, tenths(72.1), hundredths(9.70), tenths(18.2)});
  expectFacts({"ipa_apartment/map.yaml", 544, 768, tenths(29.6), hundredths(1.34), tenths(69.0)});
  expectFacts({"nav2_depot/depot.yaml", 604, 307, tenths(96.8), hundredths(3.21), tenths(0.0)});
  expectFacts({"nav2_depot/depot_keepout.yaml", 604, 307, tenths(83.2), hundredths(16.83), tenths(0.0)});
  expectFacts({"nav2_depot/depot_speed.yaml", 604, 307, tenths(0.0), hundredths(0.0), tenths(100.0)});
  expectFacts({"strands_kth/map.yaml", 260, 781, tenths(71.4), hundredths(4.87), tenths(23.7)});
  expectFacts({"aws_bookstore/map.yaml", 384, 384, tenths(42.0), hundredths(3.36), tenths(54.7)});
}

TEST_F(PublicMaps, ImagesWithoutYamlAreReadWithTheirNumbersFromOutside) {
  expectFacts({"willow_0.05/willow-full-0.05.pgm", 1165, 945, tenths(49.9), hundredths(1.22), tenths(48.9)},
              imageOptions(0.05));
}

TEST_F(PublicMaps, SixteenBitColoursAreReadAtTheirFullDepth) {
  // Counted by another program, in whole numbers.
  const auto expect_counts = [](const MapOptions& options, long free, long occupied, long unknown) {
    const auto grid = readGrid(kMaps / "freiburg_079" / "freiburg.png", options);
    ASSERT_TRUE(grid) << grid.error().message;
    EXPECT_EQ(grid->width, 911u);
    EXPECT_EQ(grid->height, 368u);
    const auto count = [&](Cell kind) { return std::count(grid->cells.begin(), grid->cells.end(), kind); };
    EXPECT_EQ(count(Cell::kFree), free);
    EXPECT_EQ(count(Cell::kOccupied), occupied);
    EXPECT_EQ(count(Cell::kUnknown), unknown);
  };
  MapOptions options = imageOptions(0.05);
  expect_counts(options, 303'962, 15'237, 16'049);
  options.occupied_thresh = 0.2;
  options.free_thresh = 0.05;
  expect_counts(options, 140'155, 31'068, 164'025);
}

TEST_F(PublicMaps, MapServersOwnTestImageGivesItsExpectedCells) {
  const auto grid = readGrid(kMaps / "map_server_test" / "testmap.yaml");
  ASSERT_TRUE(grid) << grid.error().message;
  std::ifstream file(kMaps / "map_server_test" / "testmap.expected.json");
  const auto expected = nlohmann::json::parse(file);
  EXPECT_EQ(grid->width, expected["width"]);
  EXPECT_EQ(grid->height, expected["height"]);
  EXPECT_EQ(grid->resolution_m, expected["resolution"]);
  EXPECT_EQ(grid->origin, (Pose{2.0, 3.0, 1.0}));
  std::vector<int> content;
  for (const Cell cell : grid->cells)
    content.push_back(cell == Cell::kFree ? 0 : cell == Cell::kOccupied ? 100 : -1);
  EXPECT_EQ(content, expected["content"].get<std::vector<int>>());
}

TEST_F(PublicMaps, WallsCoverExactlyTheOccupiedCells) {
  for (const char* file : {"gt_rail/ilab.yaml", "ipa_apartment/map.yaml", "utexas_gdc_3ne/3ne.yaml"}) {
    const auto grid = readGrid(kMaps / file);
    ASSERT_TRUE(grid) << grid.error().message;
    for (const Unknown unknown : {Unknown::kOccupied, Unknown::kFree}) {
      const auto blocks = blocksOf(*grid, unknown, kMostWalls);
      ASSERT_TRUE(blocks);
      std::vector<int> covered(grid->cells.size(), 0);
      for (const CellBlock& block : *blocks)
        for (std::uint32_t row = block.row; row < block.row + block.rows; ++row)
          for (std::uint32_t column = block.column; column < block.column + block.columns; ++column)
            ++covered[std::size_t{row} * grid->width + column];
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < covered.size(); ++i) {
        const bool is_wall = grid->cells[i] == Cell::kOccupied ||
                             (unknown == Unknown::kOccupied && grid->cells[i] == Cell::kUnknown);
        wrong += covered[i] != (is_wall ? 1 : 0);
      }
      EXPECT_EQ(wrong, 0u) << file << " in " << blocks->size() << " walls";
    }
  }
}

TEST_F(PublicMaps, BecomeWorlds) {
  const auto dut = readMap(kMaps / "utexas_gdc_3ne" / "3ne.yaml");
  ASSERT_TRUE(dut) << dut.error().message;
  EXPECT_EQ(dut->world.name(), "3ne");
  EXPECT_EQ(dut->world.bounds().corner, (Pose{-60.45, -23.4, 0.0}));
  EXPECT_NEAR(dut->world.bounds().width_m, 92.85, 1e-9);
  EXPECT_LT(dut->world.obstacles().size(), 20'000u);
}

TEST_F(PublicMaps, WhatIsNoMapIsRefusedByName) {
  EXPECT_TRUE(
      refusedNaming(readMap(kMaps / "humanoid_nav_nao" / "sample.yaml"), {"sample.gif", "GIF", "convert"}));
  EXPECT_TRUE(
      refusedNaming(readMap(kMaps / "map_server_test" / "testmap.bmp"), {"testmap.bmp", "BMP", "convert"}));
  EXPECT_TRUE(
      refusedNaming(readMap(kMaps / "utexas_gdc_3ne" / "doors.yaml"), {"doors.yaml:1:", "a mapping"}));
  EXPECT_TRUE(refusedNaming(readMap(kMaps / ".." / "octomap" / "fr_079.bt"), {"fr_079.bt"}));
  EXPECT_TRUE(refusedNaming(readMap(kMaps), {"maps2d", "not a file"}));
}

}  // namespace
}  // namespace underway
