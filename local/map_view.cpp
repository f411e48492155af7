#include "local/map_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/layer.hpp"
#include "local/extent.hpp"

namespace underway {
namespace {

Extent extentOf(const Plan& plan) {
  Extent extent{{plan.goal.x, plan.goal.x}, {plan.goal.y, plan.goal.y}};
  for (const Segment& segment : plan.segments)
    for (const Pose& pose : {segment.motion.from, segment.motion.to}) {
      extent.x = hull(extent.x, {pose.x, pose.x});
      extent.y = hull(extent.y, {pose.y, pose.y});
    }
  return extent;
}

}  // namespace

MapView::MapView(const World& world, Range heights, const Plan& plan, const Tolerance& tolerance,
                 double round_m)
    : far_from_m_(tolerance.far_from_m) {
  const Extent extent = extentOf(plan);
  corner_ = {extent.x.min - round_m, extent.y.min - round_m};
  columns_ = static_cast<std::int64_t>(std::ceil((extent.x.length() + 2.0 * round_m) / kCell_m));
  const auto rows = static_cast<std::int64_t>(std::ceil((extent.y.length() + 2.0 * round_m) / kCell_m));
  width_ = static_cast<double>(columns_);
  height_ = static_cast<double>(rows);
  cells_.assign(static_cast<std::size_t>(columns_ * rows), Cell::kEmpty);
  const Layer seen =
      Layer::seenIn({world.floorZ() + heights.min, world.floorZ() + heights.max}, world.obstacles());
  const auto middle_of = [&](double column, double row) {
    return Point{corner_.x + column * kCell_m, corner_.y + row * kCell_m};
  };
  const auto fill = [&](std::int64_t column, std::int64_t row) {
    const Point middle = middle_of(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
    if (!seen.touches(middle, tolerance.far_m)) return;
    cells_[static_cast<std::size_t>(row * columns_ + column)] =
        seen.touches(middle, tolerance.near_m) ? Cell::kNear : Cell::kFar;
  };
  // Most of a long plan's surroundings is empty: it is told block by block.
  constexpr std::int64_t kBlock = 32;
  constexpr double kHalf = 0.5 * static_cast<double>(kBlock);
  const double reach_m = std::numbers::sqrt2 * kHalf * kCell_m + tolerance.far_m;
  for (std::int64_t row = 0; row < rows; row += kBlock)
    for (std::int64_t column = 0; column < columns_; column += kBlock) {
      const Point middle = middle_of(static_cast<double>(column) + kHalf, static_cast<double>(row) + kHalf);
      if (!seen.touches(middle, reach_m)) continue;
      for (std::int64_t y = row; y < std::min(row + kBlock, rows); ++y)
        for (std::int64_t x = column; x < std::min(column + kBlock, columns_); ++x) fill(x, y);
    }
}

}  // namespace underway
