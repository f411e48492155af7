#include "geometry/region_grid.hpp"

#include <numeric>

namespace underway {
namespace {

constexpr double kRegionsPerCell = 2.0;
constexpr double kMostCells = 64.0;  // that a region is entered in

}  // namespace

RegionGrid::RegionGrid(std::vector<Region> regions) : regions_(std::move(regions)) {
  if (regions_.empty()) return;
  Region all = regions_.front();
  for (const Region& region : regions_) all = all.joint(region);
  min_x_ = all.min_x;
  min_y_ = all.min_y;
  const double width = std::max(all.max_x - all.min_x, 1e-3);
  const double height = std::max(all.max_y - all.min_y, 1e-3);
  const auto count = static_cast<double>(regions_.size());
  // Never many more cells than regions, also where they lie in a row.
  cell_m_ = std::max(std::sqrt(width * height * kRegionsPerCell / count), std::max(width, height) / count);
  columns_ = static_cast<std::size_t>(width / cell_m_) + 1;
  rows_ = static_cast<std::size_t>(height / cell_m_) + 1;
  first_.assign(columns_ * rows_ + 1, 0);
  for (std::uint32_t i = 0; i < regions_.size(); ++i) {
    if (isLarge(regions_[i]))
      large_.push_back(i);
    else
      visitCells(regions_[i], [&](std::size_t cell) { ++first_[cell + 1]; });
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  entries_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < regions_.size(); ++i)
    if (!isLarge(regions_[i])) visitCells(regions_[i], [&](std::size_t cell) { entries_[next[cell]++] = i; });
}

bool RegionGrid::isLarge(const Region& region) const {
  const double columns = (region.max_x - region.min_x) / cell_m_ + 1.0;
  const double rows = (region.max_y - region.min_y) / cell_m_ + 1.0;
  return columns * rows > kMostCells;
}

}  // namespace underway
