#include "local/hold.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

Velocity holdAt(const Pose& target, const Pose& at, const HoldSettings& settings, const SpeedLimits& limits) {
  const double c = std::cos(at.yaw);
  const double s = std::sin(at.yaw);
  const double dx = settings.gain * (target.x - at.x);
  const double dy = settings.gain * (target.y - at.y);
  return limited(
      {c * dx + s * dy, c * dy - s * dx, settings.heading_gain * normalizedAngle(target.yaw - at.yaw)},
      limits);
}

Velocity alongLane(double direction_rad, double speed_mps, const LaneError& error,
                   const HoldSettings& settings, const SpeedLimits& limits) {
  const double off =
      std::max(std::abs(error.left_m) / error.tolerance_m, std::abs(error.turned_rad) / error.tolerance_rad);
  const double along = speed_mps * std::clamp(1.5 - 0.5 * off, 0.0, 1.0);
  const double across = -settings.gain * error.left_m;
  // The lane's direction, seen from the body as it is turned now.
  const double c = std::cos(direction_rad - error.turned_rad);
  const double s = std::sin(direction_rad - error.turned_rad);
  return limited({c * along - s * across, s * along + c * across, -settings.heading_gain * error.turned_rad},
                 limits);
}

}  // namespace underway
