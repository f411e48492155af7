#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pose.hpp"
#include "geometry/robot.hpp"

namespace underway {

/// Places of each mode in a flat bucket grid, to find the nearest ones. Frozen once made.
class PlaceIndex {
 public:
  struct Entry {
    Point at;
    ModeId mode = 0;
    std::uint32_t place = 0;
  };

  PlaceIndex() = default;
  explicit PlaceIndex(std::vector<Entry> entries);

  /// Up to `most` places of a mode, nearest first; equally near ones by their number.
  [[nodiscard]] std::vector<std::uint32_t> nearest(ModeId mode, Point to, std::size_t most) const;

 private:
  struct Grid {
    Point corner;
    double cell_m = 1.0;
    int columns = 0;
    int rows = 0;
    std::vector<Entry> entries;        // ordered by cell
    std::vector<std::uint32_t> first;  // of each cell; one more at the end
  };
  [[nodiscard]] static Grid gridOf(std::vector<Entry> entries);
  std::vector<Grid> grids_;  // by mode
};

}  // namespace underway
