#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pose.hpp"
#include "planner/groups.hpp"

namespace underway {

/// Places of each group in a flat bucket grid, to find the nearest ones. Frozen once made.
class PlaceIndex {
 public:
  struct Entry {
    Point at;
    GroupId group = 0;
    std::uint32_t place = 0;
  };

  PlaceIndex() = default;
  explicit PlaceIndex(std::vector<Entry> entries);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Up to `most` places of a group, nearest first; equally near ones by their number.
  [[nodiscard]] std::vector<std::uint32_t> nearest(GroupId group, Point to, std::size_t most) const;

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
  std::size_t size_ = 0;
  std::vector<Grid> grids_;  // by group
};

}  // namespace underway
