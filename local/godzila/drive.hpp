#pragma once

#include "local/command.hpp"
#include "local/godzila/heading.hpp"

namespace underway {

/// From the best heading to a velocity (Brooks 2017, (3.18)): slower near obstacles, slower while turning.
///
///   w = w_max clip(5 turn / pi, -1, 1),   v = v_max min(1, Kv (r'_min / Kf)^2 / (Kb w^2 + 1e-4))
///
/// where w in v's denominator is the turning rate [rad/s]. `facing_rad` is the direction the robot goes on
/// in: 0 ahead; that of a sense for the sideways form, in which the body turns the same and v lies along the
/// sense. Speeds are shares of `limits`, limited to them.
[[nodiscard]] Velocity velocityTowards(const HeadingOptimum::Result& optimum, const GodzilaSettings& settings,
                                       const SpeedLimits& limits, double facing_rad = 0.0);

/// The turning rate alone, for a heading that is off by an angle [rad/s].
[[nodiscard]] double turnTowards(double off_rad, const GodzilaSettings& settings, const SpeedLimits& limits);

}  // namespace underway
