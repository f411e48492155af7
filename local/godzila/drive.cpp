#include "local/godzila/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway {

double turnTowards(double off_rad, const GodzilaSettings& settings, const SpeedLimits& limits) {
  const double share = std::clamp(5.0 * off_rad / std::numbers::pi, settings.least_turn, settings.most_turn);
  return share * limits.turn_radps;
}

Velocity velocityTowards(const HeadingOptimum::Result& optimum, const GodzilaSettings& settings,
                         const SpeedLimits& limits, double facing_rad) {
  const double turn = turnTowards(normalizedAngle(optimum.heading_rad - facing_rad), settings, limits);
  const double near =
      shortened(optimum.nearest_m, settings.clearance_threshold_m) / settings.forward_repulsion;
  const double share = settings.velocity_gain * near * near / (settings.turn_braking * turn * turn + 1e-4);
  const double top = limits.forward_mps;
  const double speed = top * std::clamp(share, settings.least_speed, settings.most_speed);
  return limited({speed * std::cos(facing_rad), speed * std::sin(facing_rad), turn}, limits);
}

}  // namespace underway
