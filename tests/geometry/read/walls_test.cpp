#include "geometry/read/walls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace underway {
namespace {

constexpr std::size_t kMany = 1'000'000;

/// Rows from the top, as one sees them: '#' occupied, '.' free, '?' unknown.
Grid gridOf(const std::vector<std::string>& rows, Pose origin = {}, double resolution_m = 0.05) {
  Grid grid{static_cast<std::uint32_t>(rows[0].size()),
            static_cast<std::uint32_t>(rows.size()),
            resolution_m,
            origin,
            {}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : *row)
      grid.cells.push_back(c == '#' ? Cell::kOccupied : c == '?' ? Cell::kUnknown : Cell::kFree);
  return grid;
}

/// How often each cell is covered.
std::vector<int> coverage(const Grid& grid, const std::vector<CellBlock>& blocks) {
  std::vector<int> count(grid.cells.size(), 0);
  for (const CellBlock& block : blocks)
    for (std::uint32_t row = block.row; row < block.row + block.rows; ++row)
      for (std::uint32_t column = block.column; column < block.column + block.columns; ++column)
        ++count.at(std::size_t{row} * grid.width + column);
  return count;
}

void expectExactlyCovered(const Grid& grid, Unknown unknown) {
  const auto blocks = blocksOf(grid, unknown, kMany);
  ASSERT_TRUE(blocks);
  const std::vector<int> count = coverage(grid, *blocks);
  for (std::size_t i = 0; i < count.size(); ++i) {
    const bool is_wall = grid.cells[i] == Cell::kOccupied ||
                         (grid.cells[i] == Cell::kUnknown && unknown == Unknown::kOccupied);
    ASSERT_EQ(count[i], is_wall ? 1 : 0) << "cell " << i;
  }
}

TEST(Walls, AFullGridIsOneWall) {
  const Grid grid = gridOf({"###", "###"});
  EXPECT_EQ(blocksOf(grid, Unknown::kOccupied, kMany), (std::vector<CellBlock>{{0, 0, 3, 2}}));
}

TEST(Walls, TheDirectionThatNeedsFewerWallsIsTaken) {
  const Grid comb = gridOf({"#.#.#", "#.#.#", "#####"});  // along the rows 4, along the columns 5
  EXPECT_EQ(blocksOf(comb, Unknown::kOccupied, kMany)->size(), 4u);
  const Grid lying = gridOf({"###", "..#", "###", "..#", "###"});
  EXPECT_EQ(blocksOf(lying, Unknown::kOccupied, kMany)->size(), 4u);
}

TEST(Walls, UnknownCellsAreWallsUnlessToldOtherwise) {
  const Grid grid = gridOf({"?.#"});
  EXPECT_EQ(blocksOf(grid, Unknown::kOccupied, kMany)->size(), 2u);
  EXPECT_EQ(blocksOf(grid, Unknown::kFree, kMany), (std::vector<CellBlock>{{2, 0, 1, 1}}));
}

TEST(Walls, AFreeGridHasNone) {
  EXPECT_TRUE(blocksOf(gridOf({"...", "..."}), Unknown::kOccupied, kMany)->empty());
}

TEST(Walls, TooManyAreRefusedWithTheFile) {
  EXPECT_FALSE(blocksOf(gridOf({"#.#", ".#.", "#.#"}), Unknown::kOccupied, 4));
  EXPECT_TRUE(blocksOf(gridOf({"#.#", ".#.", "#.#"}), Unknown::kOccupied, 5));

  Grid chequered{2000, 2000, 0.05, {}, {}};
  for (std::uint32_t i = 0; i < 4'000'000; ++i)
    chequered.cells.push_back((i / 2000 + i % 2000) % 2 == 0 ? Cell::kOccupied : Cell::kFree);
  const auto walls = wallsOf(chequered, Unknown::kOccupied, 0.0, 1.0, "noise.pgm");
  ASSERT_FALSE(walls);
  EXPECT_NE(walls.error().message.find("noise.pgm"), std::string::npos);
}

TEST(Walls, TheUnionIsExactlyTheOccupiedCellsOfRandomGrids) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 300; ++round) {
    const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    Grid grid{1 + below(40), 1 + below(40), 0.05, {}, {}};
    const std::uint32_t occupied_per_cent = below(101);
    for (std::uint32_t i = 0; i < grid.width * grid.height; ++i)
      grid.cells.push_back(below(100) < occupied_per_cent ? Cell::kOccupied
                           : below(2) == 0                ? Cell::kUnknown
                                                          : Cell::kFree);
    expectExactlyCovered(grid, Unknown::kOccupied);
    expectExactlyCovered(grid, Unknown::kFree);
  }
}

TEST(Walls, AWallStandsOnTheFloorOverItsCells) {
  const Grid grid = gridOf({"....", ".##.", "...."}, {10.0, 20.0, 0.0}, 0.5);
  const Obstacle dut = wallOf(grid, {1, 1, 2, 1}, 0.25, 2.0);
  EXPECT_EQ(dut.id, "wall_1_1");
  EXPECT_EQ(dut.box.center_m, (Vec3{11.0, 20.75, 1.25}));
  EXPECT_EQ(dut.box.size_m, (Vec3{1.0, 0.5, 2.0}));
  EXPECT_EQ(dut.box.rpy_rad, (Vec3{0.0, 0.0, 0.0}));
}

TEST(Walls, ATurnedGridTurnsItsWallsAndBoundsAboutItsLowerLeftCorner) {
  const double yaw = 0.5;
  const Grid grid = gridOf({"..#"}, {2.0, 3.0, yaw}, 0.1);
  const Obstacle dut = wallOf(grid, {2, 0, 1, 1}, 0.0, 1.0);
  EXPECT_NEAR(dut.box.center_m.x, 2.0 + 0.25 * std::cos(yaw) - 0.05 * std::sin(yaw), 1e-12);
  EXPECT_NEAR(dut.box.center_m.y, 3.0 + 0.25 * std::sin(yaw) + 0.05 * std::cos(yaw), 1e-12);
  EXPECT_EQ(dut.box.rpy_rad.z, yaw);
  EXPECT_EQ(boundsOf(grid).corner, grid.origin);
  EXPECT_DOUBLE_EQ(boundsOf(grid).width_m, 0.3);
  EXPECT_DOUBLE_EQ(boundsOf(grid).height_m, 0.1);
}

}  // namespace
}  // namespace underway
