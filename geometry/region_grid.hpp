#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/pose.hpp"

namespace underway {

/// An axis-aligned region of the map [m].
struct Region {
  double min_x = 0.0;
  double min_y = 0.0;
  double max_x = 0.0;
  double max_y = 0.0;

  [[nodiscard]] static Region between(Point a, Point b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
  }
  [[nodiscard]] Region grown(double by_m) const {
    return {min_x - by_m, min_y - by_m, max_x + by_m, max_y + by_m};
  }
  [[nodiscard]] Region joint(const Region& other) const {
    return {std::min(min_x, other.min_x), std::min(min_y, other.min_y), std::max(max_x, other.max_x),
            std::max(max_y, other.max_y)};
  }
  [[nodiscard]] bool overlaps(const Region& other) const {
    return min_x <= other.max_x && other.min_x <= max_x && min_y <= other.max_y && other.min_y <= max_y;
  }
};

/// Finds regions that overlap another, by a grid of cells. Simple enough to be trusted by what checks the
/// rest; made in a pass over the regions. Never changed once made; any number of threads may read it.
class RegionGrid {
 public:
  RegionGrid() = default;
  /// Regions are known by their index.
  explicit RegionGrid(std::vector<Region> regions);

  /// Calls visit(index) for each that overlaps a region or touches it; some may come twice.
  template <class Visit>
  void visit(const Region& region, const Visit& visit) const {
    const auto look = [&](std::uint32_t index) {
      if (regions_[index].overlaps(region)) visit(index);
    };
    for (const std::uint32_t index : large_) look(index);
    if (first_.empty()) return;
    visitCells(region, [&](std::size_t cell) {
      for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) look(entries_[i]);
    });
  }

 private:
  template <class Visit>
  void visitCells(const Region& region, const Visit& visit) const {
    const auto cell = [&](double at, double origin, std::size_t count) {
      return static_cast<std::size_t>(
          std::clamp(std::floor((at - origin) / cell_m_), 0.0, static_cast<double>(count - 1)));
    };
    const std::size_t left = cell(region.min_x, min_x_, columns_);
    const std::size_t right = cell(region.max_x, min_x_, columns_);
    const std::size_t low = cell(region.min_y, min_y_, rows_);
    const std::size_t high = cell(region.max_y, min_y_, rows_);
    for (std::size_t row = low; row <= high; ++row)
      for (std::size_t column = left; column <= right; ++column) visit(row * columns_ + column);
  }
  [[nodiscard]] bool isLarge(const Region& region) const;

  std::vector<Region> regions_;
  std::vector<std::uint32_t> large_;  // those that would fill many cells, looked at each time
  double min_x_ = 0.0;
  double min_y_ = 0.0;
  double cell_m_ = 1.0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::uint32_t> first_;    // of each cell; one more at the end
  std::vector<std::uint32_t> entries_;  // indices, ordered by cell
};

}  // namespace underway
