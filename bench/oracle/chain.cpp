#include "bench/oracle/chain.hpp"

#include <cmath>
#include <numbers>

namespace underway::bench {
namespace {

constexpr double kNothing_m = 1e-10;  // shorter is rounding
constexpr double kNothing_rad = 1e-12;

/// The motion, begun where the last one ended. A translation keeps its end, or its length if the heading has
/// changed by rounding.
Motion begunAt(const Pose& from, const Robot& robot, const Motion& motion) {
  switch (motion.kind) {
    case MotionKind::kTranslate:
      return translate(motion.mode, motion.sense, from, motion.to.position());
    case MotionKind::kTurn:
      return turn(motion.mode, from, motion.angle_rad, motion.to.yaw);
    case MotionKind::kSwitch:
      return switchModes(*robot.findSwitch(motion.mode, motion.to_mode), from);
  }
  return motion;
}

bool isNothing(const Motion& motion) {
  if (motion.kind == MotionKind::kTranslate) return length(motion) < kNothing_m;
  return motion.kind == MotionKind::kTurn && std::abs(motion.angle_rad) < kNothing_rad &&
         motion.to.yaw == motion.from.yaw;
}

/// Two motions as one, if they are in line and that is free.
std::optional<Motion> joint(const Keep& keep, const Motion& a, const Motion& b) {
  if (a.kind != b.kind || a.mode != b.mode || a.kind == MotionKind::kSwitch) return std::nullopt;
  Motion both = a;
  if (a.kind == MotionKind::kTranslate) {
    if (a.sense != b.sense) return std::nullopt;
    both = translate(a.mode, a.sense, a.from, b.to.position());
  } else {
    both = turn(a.mode, a.from, a.angle_rad + b.angle_rad, b.to.yaw);
  }
  return keep.isFree(both) ? std::optional(both) : std::nullopt;
}

Route joined(const Keep& keep, const Route& route) {
  Route result;
  for (const Motion& motion : route) {
    const auto both = result.empty() ? std::nullopt : joint(keep, result.back(), motion);
    if (both)
      result.back() = *both;
    else
      result.push_back(motion);
    if (isNothing(result.back())) result.pop_back();
  }
  return result;
}

}  // namespace

Motion reversed(const Motion& motion, ModeId mode) {
  if (motion.kind == MotionKind::kTurn) return turn(mode, motion.to, -motion.angle_rad, motion.from.yaw);
  return translate(mode, opposite(motion.sense), motion.to, motion.from.position());
}

Route chained(const Checker& checker, const Keep& keep, const Gaits& gaits, const Route& route,
              const Request& request) {
  const Robot& robot = checker.robot();
  Route whole;
  Pose at = request.start;
  for (const Motion& motion : route) {
    whole.push_back(begunAt(at, robot, motion));
    at = whole.back().to;
  }
  Route result;
  at = request.start;
  ModeId mode = request.start_mode;
  const auto change = [&](ModeId to) {
    if (mode == to || gaits.of_mode[mode] != gaits.of_mode[to]) return;
    result.push_back(switchModes(*robot.findSwitch(mode, to), at));
    mode = to;
  };
  for (const Motion& motion : joined(keep, whole)) {
    // Either companion may turn: the one it is in does, if it is as fast.
    Motion next = begunAt(at, robot, motion);
    if (next.kind == MotionKind::kTurn && gaits.of_mode[mode] == gaits.of_mode[next.mode] &&
        robot.modes[mode].turn_speed_radps == robot.modes[next.mode].turn_speed_radps)
      next.mode = next.to_mode = mode;
    change(next.mode);
    result.push_back(next);
    at = next.to;
    mode = next.to_mode;
  }
  change(request.goal_mode);
  return result;
}

Cost totalCost(const Robot& robot, Policy policy, const Route& route) {
  Cost sum;
  for (const Motion& motion : route) sum = sum + costOf(robot, policy, motion);
  return sum;
}

Plan planOf(const Checker& checker, const Route& route, const Request& request) {
  std::vector<Segment> segments;
  for (const Motion& motion : route)
    segments.push_back(
        {motion, duration(checker.robot(), motion), checker.closeness(motion, kClearanceCap_m)});
  return timedPlan(std::move(segments), request.start);
}

}  // namespace underway::bench
