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
  constexpr double kLeast_m = 0.02;  // a beam inside the threshold weighs much, not infinitely
  return std::max(range_m - clearance_threshold_m * std::exp(-range_m), kLeast_m);
}

HeadingOptimum::HeadingOptimum(const GodzilaSettings& settings, const Beams& beams)
    : settings_(settings), beams_(beams) {
  directions_.reserve(beams.count);
  for (std::size_t i = 0; i < beams.count; ++i)
    directions_.push_back({std::cos(beams.bearing(i)), std::sin(beams.bearing(i))});
}

HeadingOptimum::Result HeadingOptimum::of(const Scan& scan, const Bearing& goal, double facing_rad) const {
  const GodzilaSettings& s = settings_;
  const double width = s.bearing_width_rad * s.bearing_width_rad;
  const double farthest = shortened(s.farthest_m, s.clearance_threshold_m);
  Point alpha{0.0, 0.0};
  Result result{{}, facing_rad, s.farthest_m, facing_rad};
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const double range = std::min(static_cast<double>(scan.ranges_m[i]), s.farthest_m);
    const double bearing = beams_.bearing(i);
    const double off_goal = normalizedAngle(bearing - goal.bearing_rad);
    const double to_goal = off_goal * off_goal + width;  // 1 / L
    const double r = range < s.farthest_m ? shortened(range, s.clearance_threshold_m) : farthest;
    double weight;
    if (range < s.obstacle_threshold_m) {
      const double off_ahead = normalizedAngle(bearing - facing_rad);
      const double ahead = off_ahead * off_ahead + width;
      // (3.15), its quotients brought together: one division is quicker than three.
      weight = -s.obstacle_repulsion * ((1.0 - s.bearing_ratio) * ahead + s.bearing_ratio * to_goal) /
               (r * r * to_goal * ahead);
    } else {
      weight = s.obstacle_attraction * r * r / to_goal;  // (3.16)
    }
    alpha.x += weight * directions_[i].x;
    alpha.y += weight * directions_[i].y;
    if (range < result.nearest_m) result.nearest_m = range, result.nearest_rad = bearing;
  }
  constexpr double kNearestGoal_m = 0.05;  // at the goal itself its pull has no direction
  const double range = std::max(goal.range_m, kNearestGoal_m);
  const double pull = s.goal_attraction / (range * range);  // (3.14)
  alpha.x += pull * std::cos(goal.bearing_rad) + s.inertia * std::cos(facing_rad);
  alpha.y += pull * std::sin(goal.bearing_rad) + s.inertia * std::sin(facing_rad);  // (3.17)
  result.alpha = alpha;
  if (alpha.x != 0.0 || alpha.y != 0.0) result.heading_rad = std::atan2(alpha.y, alpha.x);
  return result;
}

}  // namespace underway
