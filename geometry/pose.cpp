#include "geometry/pose.hpp"

#include <cmath>
#include <numbers>

namespace underway {

double counterClockwise(double from_rad, double to_rad) {
  const double way = std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi);
  const double positive = way < 0.0 ? way + 2.0 * std::numbers::pi : way;
  return positive < 2.0 * std::numbers::pi ? positive
                                           : 0.0;  // a hair below 0 rounds up to a whole revolution
}

Pose compose(const Pose& base, const Pose& relative) {
  const Point at = transform(base, relative.position());
  return {at.x, at.y, relative.yaw == 0.0 ? base.yaw : normalizedAngle(base.yaw + relative.yaw)};
}

Pose before(const Pose& to, const Pose& relative) {
  const double yaw = relative.yaw == 0.0 ? to.yaw : normalizedAngle(to.yaw - relative.yaw);
  const Point moved = transform({0.0, 0.0, yaw}, relative.position());
  return {to.x - moved.x, to.y - moved.y, yaw};
}

Point transform(const Pose& base, Point local) {
  const double c = std::cos(base.yaw);
  const double s = std::sin(base.yaw);
  return {base.x + c * local.x - s * local.y, base.y + s * local.x + c * local.y};
}

double distance(Point a, Point b) { return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)); }

}  // namespace underway
