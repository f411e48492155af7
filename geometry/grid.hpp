#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "geometry/error.hpp"
#include "geometry/map.hpp"
#include "geometry/pose.hpp"

namespace underway {

/// What a map knows about one square of floor.
enum class Cell : std::uint8_t { kFree, kOccupied, kUnknown };

/// Cells in columns and rows. `origin` is the lower left corner of column 0, row 0; its x axis runs along the
/// rows.
struct Grid {
  std::uint32_t width = 0;    ///< columns
  std::uint32_t height = 0;   ///< rows
  double resolution_m = 0.0;  ///< side of a cell
  Pose origin;                ///< in the map frame
  std::vector<Cell> cells;    ///< width * height, row by row, row 0 the lowest

  [[nodiscard]] Cell at(std::uint32_t column, std::uint32_t row) const {
    return cells[std::size_t{row} * width + column];
  }
};

/// The cells of a ROS map_server YAML with its image, or of an image (PGM, PNG) whose numbers are in the
/// options: what readMap turns into walls. Errors: kInvalidMap, one sentence with the file.
[[nodiscard]] Expected<Grid> readGrid(const std::filesystem::path& file, const MapOptions& options = {});

}  // namespace underway
