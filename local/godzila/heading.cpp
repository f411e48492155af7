#include "local/godzila/heading.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

Bearing bearingOf(Point goal, const Pose& from) {
  const double dx = goal.x - from.x;
  const double dy = goal.y - from.y;
  return {std::hypot(dx, dy), normalizedAngle(std::atan2(dy, dx) - from.yaw)};
}

double shortened(double range_m, double clearance_threshold_m) {
  return std::max(range_m - clearance_threshold_m * std::exp(-range_m), kLeastShortened_m);
}

HeadingOptimum::HeadingOptimum(const GodzilaSettings& settings, const Beams& beams)
    : settings_(settings), beams_(beams), pull_(settings, beams) {}

HeadingOptimum::Result HeadingOptimum::of(const Scan& scan, const Bearing& goal, double facing_rad) const {
  const double goal_rad = normalizedAngle(goal.bearing_rad);
  Point alpha = pull_.of(scan.ranges_m, goal_rad, normalizedAngle(facing_rad));  // (3.15), (3.16)
  constexpr double kNearestGoal_m = 0.05;  // at the goal itself its pull has no direction
  const double range = std::max(goal.range_m, kNearestGoal_m);
  const double pull = settings_.goal_attraction / (range * range);  // (3.14)
  alpha.x += pull * std::cos(goal_rad) + settings_.inertia * std::cos(facing_rad);
  alpha.y += pull * std::sin(goal_rad) + settings_.inertia * std::sin(facing_rad);  // (3.17)
  Result result{alpha, facing_rad, settings_.farthest_m, facing_rad};
  if (alpha.x != 0.0 || alpha.y != 0.0) result.heading_rad = std::atan2(alpha.y, alpha.x);
  const auto nearest = std::min_element(scan.ranges_m.begin(), scan.ranges_m.end());
  if (nearest != scan.ranges_m.end() && *nearest < settings_.farthest_m) {
    result.nearest_m = *nearest;
    result.nearest_rad = beams_.bearing(static_cast<std::size_t>(nearest - scan.ranges_m.begin()));
  }
  return result;
}

}  // namespace underway
