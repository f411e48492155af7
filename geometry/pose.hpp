#pragma once

#include <cmath>
#include <numbers>

namespace underway {

/// A point in the plane of the map frame: x right, y up [m].
struct Point {
  double x = 0.0;  ///< [m]
  double y = 0.0;  ///< [m]
  bool operator==(const Point&) const = default;
};

/// Position and heading of a body frame in the map frame (or of a frame in a body frame, for displacements).
struct Pose {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< where the front points, counter-clockwise from the x axis [rad]
  bool operator==(const Pose&) const = default;
  [[nodiscard]] Point position() const { return {x, y}; }
};

/// The same angle in (-pi, pi] [rad].
[[nodiscard]] inline double normalizedAngle(double angle_rad) {
  constexpr double kPi = std::numbers::pi;
  if (angle_rad > -kPi && angle_rad <= kPi) return angle_rad;
  if (std::abs(angle_rad) < 3.0 * kPi)
    return angle_rad > 0.0 ? angle_rad - 2.0 * kPi : angle_rad + 2.0 * kPi;  // exact
  const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

/// The counter-clockwise way from one heading to another, in [0, 2 pi) [rad].
[[nodiscard]] double counterClockwise(double from_rad, double to_rad);

/// The pose `relative`, given in the frame of `base`, in the frame of the map. The yaw is normalised, unless
/// the relative yaw is 0: then it is the base's yaw, bit for bit.
[[nodiscard]] Pose compose(const Pose& base, const Pose& relative);

/// The base that a relative pose leads from to `to`: compose(before(to, relative), relative) is `to`, but for
/// rounding.
[[nodiscard]] Pose before(const Pose& to, const Pose& relative);

/// A point given in the frame of `base`, in the frame of the map.
[[nodiscard]] Point transform(const Pose& base, Point local);

[[nodiscard]] double distance(Point a, Point b);

}  // namespace underway
