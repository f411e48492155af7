#include "local/command.hpp"

#include <algorithm>
#include <cmath>

namespace underway {
namespace {

bool isStandingTogether(const Robot& robot, ModeId mode) {
  if (mode == 0) return true;
  const Switch* there = robot.findSwitch(0, mode);
  const Switch* back = robot.findSwitch(mode, 0);
  return there != nullptr && back != nullptr && there->duration_s == 0.0 && back->duration_s == 0.0 &&
         robot.modes[mode].body_m == robot.modes[0].body_m;
}

}  // namespace

SpeedLimits standingLimits(const Robot& robot) {
  SpeedLimits limits;
  for (std::size_t i = 0; i < robot.modes.size(); ++i) {
    if (!isStandingTogether(robot, static_cast<ModeId>(i))) continue;
    const Mode& mode = robot.modes[i];
    limits.forward_mps = std::max(limits.forward_mps, mode.speed(Sense::kForward));
    limits.backward_mps = std::max(limits.backward_mps, mode.speed(Sense::kBackward));
    limits.left_mps = std::max(limits.left_mps, mode.speed(Sense::kLeft));
    limits.right_mps = std::max(limits.right_mps, mode.speed(Sense::kRight));
    limits.turn_radps = std::max(limits.turn_radps, mode.turn_speed_radps);
  }
  return limits;
}

Velocity limited(const Velocity& velocity, const SpeedLimits& limits) {
  const auto share = [](double speed, double most) {
    return speed == 0.0 ? 0.0 : most > 0.0 ? speed / most : std::copysign(1e9, speed);
  };
  const double along =
      share(velocity.x_mps, velocity.x_mps >= 0.0 ? limits.forward_mps : limits.backward_mps);
  const double across = share(velocity.y_mps, velocity.y_mps >= 0.0 ? limits.left_mps : limits.right_mps);
  const double over = std::max(1.0, std::hypot(along, across));
  return {velocity.x_mps / over, velocity.y_mps / over,
          std::clamp(velocity.turn_radps, -limits.turn_radps, limits.turn_radps)};
}

}  // namespace underway
