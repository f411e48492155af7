#pragma once

#include "local/command.hpp"

namespace underway {

struct HoldSettings {
  double gain = 0.8;          ///< of position errors [1/s]
  double heading_gain = 1.0;  ///< of heading errors [1/s]
};

/// The velocity that brings a holonomic robot from a pose towards another, and holds it there.
[[nodiscard]] Velocity holdAt(const Pose& target, const Pose& at, const HoldSettings& settings,
                              const SpeedLimits& limits);

/// The velocity that follows a straight line at a speed, steering errors across it and of the heading to
/// zero; the further off, the slower it goes on. `left_m` and `turned_rad` are the errors.
struct LaneError {
  double left_m = 0.0;
  double turned_rad = 0.0;
  double tolerance_m = 0.01;  ///< beyond three of these it stops going on
  double tolerance_rad = 0.02;
};
[[nodiscard]] Velocity alongLane(double direction_rad, double speed_mps, const LaneError& error,
                                 const HoldSettings& settings, const SpeedLimits& limits);

}  // namespace underway
