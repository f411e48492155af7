#pragma once

#include <cstdint>
#include <vector>

#include "geometry/world.hpp"
#include "planner/plan.hpp"

namespace underway {

/// How near to something in the map what is seen may be to be that. What is near is seen more exactly.
struct Tolerance {
  double near_m = 0.045;  ///< of what is nearer than `far_from_m` [m]
  double far_m = 0.12;    ///< of all else [m]
  double far_from_m = 1.2;
};

/// What a planar sense should see round a plan, by the map: cells of the floor where, within a tolerance,
/// something stands at the sense's heights. What a beam ends on elsewhere is not in the map.
///
/// Made when a plan is taken; asking takes nanoseconds and allocates nothing.
class MapView {
 public:
  static constexpr double kCell_m = 0.025;

  MapView() = default;
  /// `heights` above the floor; `round_m` is how far round the plan it is told.
  MapView(const World& world, Range heights, const Plan& plan, const Tolerance& tolerance, double round_m);

  /// Whether something that was seen here, from so far away, is in the map. Outside what is told everything
  /// is.
  [[nodiscard]] bool isExpected(Point at, double range_m) const {
    const double column = (at.x - corner_.x) * (1.0 / kCell_m);
    const double row = (at.y - corner_.y) * (1.0 / kCell_m);
    if (!(column >= 0.0 && row >= 0.0 && column < width_ && row < height_)) return true;
    const auto before = static_cast<std::int64_t>(row) * columns_;  // signed: quicker from a double
    const Cell cell = cells_[static_cast<std::size_t>(before + static_cast<std::int64_t>(column))];
    return cell == Cell::kNear || (cell == Cell::kFar && range_m >= far_from_m_);
  }

 private:
  enum class Cell : std::uint8_t { kEmpty, kFar, kNear };  // what it is near enough to

  double far_from_m_ = 0.0;
  Point corner_;
  std::int64_t columns_ = 0;
  double width_ = 0.0;  // in cells, as below
  double height_ = 0.0;
  std::vector<Cell> cells_;
};

}  // namespace underway
