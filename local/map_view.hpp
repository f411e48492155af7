#pragma once

#include <cstdint>
#include <vector>

#include "geometry/world.hpp"
#include "planner/plan.hpp"

namespace underway {

/// What a planar sense should see round a plan, by the map: cells of the floor where, within a tolerance,
/// something stands at the sense's heights. What a beam ends on elsewhere is not in the map.
///
/// Made when a plan is taken; asking takes nanoseconds and allocates nothing.
class MapView {
 public:
  static constexpr double kCell_m = 0.05;

  MapView() = default;
  /// `heights` above the floor; `round_m` is how far round the plan it is told.
  MapView(const World& world, Range heights, const Plan& plan, double tolerance_m, double round_m);

  /// Whether something that was seen here is in the map. Outside what is told everything is.
  [[nodiscard]] bool isExpected(Point at) const;

 private:
  Point corner_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::uint8_t> cells_;
};

}  // namespace underway
