#include "planner/place_index.hpp"

#include <algorithm>
#include <cmath>

namespace underway {
namespace {

constexpr double kEntriesPerCell = 2.0;

int cellOf(double offset_m, double cell_m, int count) {
  return std::clamp(static_cast<int>(std::floor(offset_m / cell_m)), 0, count - 1);
}

}  // namespace

PlaceIndex::PlaceIndex(std::vector<Entry> entries) : size_(entries.size()) {
  std::vector<std::vector<Entry>> by_group;
  for (const Entry& entry : entries) {
    if (by_group.size() <= entry.group) by_group.resize(entry.group + 1U);
    by_group[entry.group].push_back(entry);
  }
  for (std::vector<Entry>& of_group : by_group) grids_.push_back(gridOf(std::move(of_group)));
}

PlaceIndex::Grid PlaceIndex::gridOf(std::vector<Entry> entries) {
  Grid grid;
  if (entries.empty()) return grid;
  Point low = entries[0].at;
  Point high = low;
  for (const Entry& entry : entries) {
    low = {std::min(low.x, entry.at.x), std::min(low.y, entry.at.y)};
    high = {std::max(high.x, entry.at.x), std::max(high.y, entry.at.y)};
  }
  const double width = std::max(high.x - low.x, 0.1);
  const double height = std::max(high.y - low.y, 0.1);
  grid.corner = low;
  grid.cell_m = std::sqrt(width * height * kEntriesPerCell / static_cast<double>(entries.size()));
  // A long row of places makes thin cells: never more cells than places.
  grid.cell_m = std::max(grid.cell_m, std::max(width, height) / static_cast<double>(entries.size()));
  grid.columns = static_cast<int>(width / grid.cell_m) + 1;
  grid.rows = static_cast<int>(height / grid.cell_m) + 1;
  const auto cell = [&](const Entry& entry) {
    return static_cast<std::size_t>(cellOf(entry.at.y - low.y, grid.cell_m, grid.rows) * grid.columns +
                                    cellOf(entry.at.x - low.x, grid.cell_m, grid.columns));
  };
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const Entry& a, const Entry& b) { return cell(a) < cell(b); });
  grid.first.assign(static_cast<std::size_t>(grid.columns * grid.rows) + 1, 0);
  for (const Entry& entry : entries) ++grid.first[cell(entry) + 1];
  for (std::size_t i = 1; i < grid.first.size(); ++i) grid.first[i] += grid.first[i - 1];
  grid.entries = std::move(entries);
  return grid;
}

std::vector<std::uint32_t> PlaceIndex::nearest(GroupId group, Point to, std::size_t most) const {
  if (group >= grids_.size() || grids_[group].entries.empty() || most == 0) return {};
  const Grid& grid = grids_[group];
  const int column = cellOf(to.x - grid.corner.x, grid.cell_m, grid.columns);
  const int row = cellOf(to.y - grid.corner.y, grid.cell_m, grid.rows);
  std::vector<std::pair<double, std::uint32_t>> found;
  const auto scan = [&](int c, int r) {
    if (c < 0 || r < 0 || c >= grid.columns || r >= grid.rows) return;
    const auto at = static_cast<std::size_t>(r * grid.columns + c);
    for (std::uint32_t i = grid.first[at]; i < grid.first[at + 1]; ++i)
      found.emplace_back(distance(grid.entries[i].at, to), grid.entries[i].place);
  };
  // Rings of cells outwards: what lies beyond ring k is more than k cells away, also from a point off the
  // grid.
  const int last = std::max(grid.columns, grid.rows);
  for (int ring = 0; ring <= last; ++ring) {
    for (int c = column - ring; c <= column + ring; ++c) {
      scan(c, row - ring);
      if (ring > 0) scan(c, row + ring);
    }
    for (int r = row - ring + 1; r < row + ring; ++r) {
      scan(column - ring, r);
      scan(column + ring, r);
    }
    if (found.size() < most) continue;
    std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(most) - 1, found.end());
    if (found[most - 1].first <= ring * grid.cell_m) break;
  }
  std::sort(found.begin(), found.end());
  if (found.size() > most) found.resize(most);
  std::vector<std::uint32_t> places;
  for (const auto& [ignored, place] : found) places.push_back(place);
  return places;
}

}  // namespace underway
