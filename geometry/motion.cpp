#include "geometry/motion.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace underway {

std::string_view name(MotionKind kind) {
  static constexpr std::array<std::string_view, 3> kNames{"translate", "turn", "switch"};
  return kNames.at(static_cast<std::size_t>(kind));
}

Motion translate(ModeId mode, Sense sense, const Pose& from, Point to) {
  return {MotionKind::kTranslate, mode, mode, sense, from, {to.x, to.y, from.yaw}, 0.0};
}

Motion translate(ModeId mode, Sense sense, const Pose& from, double distance_m) {
  const double direction = from.yaw + angleOf(sense);
  return translate(
      mode, sense, from,
      Point{from.x + distance_m * std::cos(direction), from.y + distance_m * std::sin(direction)});
}

Motion turn(ModeId mode, const Pose& from, double angle_rad, double to_yaw) {
  return {MotionKind::kTurn, mode, mode, Sense::kForward, from, {from.x, from.y, to_yaw}, angle_rad};
}

Motion stay(ModeId mode, const Pose& at) { return turn(mode, at, 0.0, at.yaw); }

Motion switchModes(const Switch& change, const Pose& from) {
  return {MotionKind::kSwitch,
          change.from,
          change.to,
          Sense::kForward,
          from,
          compose(from, change.displacement),
          0.0};
}

double duration(const Robot& robot, const Motion& motion) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Mode& mode = robot.modes.at(motion.mode);
  switch (motion.kind) {
    case MotionKind::kTranslate:
      return mode.canMove(motion.sense) ? length(motion) / mode.speed(motion.sense) : kNever;
    case MotionKind::kTurn:
      if (motion.angle_rad == 0.0) return 0.0;
      return mode.canTurn() ? std::abs(motion.angle_rad) / mode.turn_speed_radps : kNever;
    case MotionKind::kSwitch: {
      const Switch* change = robot.findSwitch(motion.mode, motion.to_mode);
      return change != nullptr ? change->duration_s : kNever;
    }
  }
  return kNever;
}

double length(const Motion& motion) {
  return motion.kind == MotionKind::kTranslate ? distance(motion.from.position(), motion.to.position()) : 0.0;
}

}  // namespace underway
