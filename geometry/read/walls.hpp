#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "geometry/grid.hpp"
#include "geometry/world.hpp"

namespace underway {

/// A rectangle of cells: its lower left cell, and how many columns and rows it has.
struct CellBlock {
  std::uint32_t column = 0;
  std::uint32_t row = 0;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  bool operator==(const CellBlock&) const = default;
};

/// Few rectangles, none overlapping, whose union is exactly the cells that are taken for occupied. In time
/// linear in the cells: greedy rectangles along the rows and along the columns, whichever are fewer. Empty if
/// there would be more than `most`.
[[nodiscard]] std::optional<std::vector<CellBlock>> blocksOf(const Grid& grid, Unknown unknown,
                                                             std::size_t most);

/// A block as an obstacle from the floor up, turned with the grid: "wall_12_30", after its lower left
/// cell.
[[nodiscard]] Obstacle wallOf(const Grid& grid, const CellBlock& block, double floor_z_m, double height_m);

/// All occupied cells as walls. Errors: kInvalidMap, if they need more than kMostWalls; `file` is for the
/// sentence.
[[nodiscard]] Expected<std::vector<Obstacle>> wallsOf(const Grid& grid, Unknown unknown, double floor_z_m,
                                                      double height_m, const std::filesystem::path& file);
inline constexpr std::size_t kMostWalls = 1'000'000;

/// The whole grid.
[[nodiscard]] Bounds boundsOf(const Grid& grid);

}  // namespace underway
