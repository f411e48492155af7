#pragma once

#include <optional>

#include "geometry/robot.hpp"

namespace underway {

/// A velocity in the body frame: x forward, y left.
struct Velocity {
  double x_mps = 0.0;       ///< forward [m/s]
  double y_mps = 0.0;       ///< to the left [m/s]
  double turn_radps = 0.0;  ///< counter-clockwise [rad/s]
  bool operator==(const Velocity&) const = default;
};

/// What the local layer tells the robot each tick.
struct Command {
  Velocity velocity;                ///< in the mode the robot is in; a crawl goes in whole gait cycles
  std::optional<ModeId> change_to;  ///< change to this mode now; the velocity is zero then
  double look_rad =
      0.0;  ///< where the head turns to, and the depth camera with it, from the body's front [rad]
  bool operator==(const Command&) const = default;
};

/// The fastest a robot moves in its standing modes: those with the first mode's body that it changes to and
/// from at once. Held like limits of one gait, because it can mix them.
struct SpeedLimits {
  double forward_mps = 0.0;
  double backward_mps = 0.0;
  double left_mps = 0.0;
  double right_mps = 0.0;
  double turn_radps = 0.0;
};
[[nodiscard]] SpeedLimits standingLimits(const Robot& robot);

/// The velocity shortened, its direction kept, until its translation lies in the ellipse of the limits; the
/// turn is limited by itself.
[[nodiscard]] Velocity limited(const Velocity& velocity, const SpeedLimits& limits);

}  // namespace underway
