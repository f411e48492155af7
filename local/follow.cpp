#include "local/follow.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/sweep.hpp"
#include "local/godzila/drive.hpp"

namespace underway {
namespace {

/// How exactly to go: a third of the clearance.
LaneError errorOf(const OnLane& lane, double clearance_m) {
  const double tolerance = std::clamp(clearance_m / 3.0, 0.006, 0.03);
  return {lane.left_m, lane.turned_rad, tolerance, std::max(tolerance / 0.25, 0.02)};
}

}  // namespace

Follow::Follow(const FollowSettings& settings, std::shared_ptr<const Robot> robot, const Beams& beams)
    : settings_(settings),
      robot_(std::move(robot)),
      limits_(standingLimits(*robot_)),
      optimum_(settings.godzila, beams) {}

void Follow::begin(const Segment& segment, const Pose& at, const Checker& checker) {
  allowance_m_ = allowanceOn(segment, checker);
  turned_rad_ = normalizedAngle(at.yaw - segment.motion.from.yaw);
  last_yaw_ = at.yaw;
}

/// The clearance, less what the turned body needs, and inside the bounds, which are nobody's clearance.
double Follow::allowanceOn(const Segment& segment, const Checker& checker) const {
  const Motion& motion = segment.motion;
  if (motion.kind != MotionKind::kTranslate || segment.closeness.clearance_m < settings_.roomy_m) return 0.0;
  const BodyBox& body = robot_->modes[motion.mode].body_m;
  const bool along_x = motion.sense == Sense::kForward || motion.sense == Sense::kBackward;
  const double turned = reachOf(body) - 0.5 * (along_x ? body.y : body.x).length();
  constexpr double kSpare_m = 0.05;
  constexpr double kStep_m = 0.05;
  for (double allowed = segment.closeness.clearance_m - turned - kSpare_m; allowed > 0.0; allowed -= kStep_m)
    if (checker.isInBounds(shifted(motion, allowed + turned)) &&
        checker.isInBounds(shifted(motion, -allowed - turned)))
      return allowed;
  return 0.0;
}

double Follow::progress(const Segment& segment, const Pose& at) const {
  if (segment.motion.kind == MotionKind::kTranslate) return onLane(segment.motion, at).along_m;
  return std::copysign(1.0, segment.motion.angle_rad) * turned_rad_;
}

Velocity Follow::along(const Segment& segment, const Pose& at, const Scan* scan, double shift_m) {
  turned_rad_ += normalizedAngle(at.yaw - last_yaw_);
  last_yaw_ = at.yaw;
  const Motion& motion = segment.motion;
  if (motion.kind == MotionKind::kTurn)
    return turnOn(motion, at, errorOf({}, segment.closeness.clearance_m).tolerance_m);
  const OnLane lane = onLane(motion, at);
  const double left = length(motion) - lane.along_m;
  const bool has_room = std::abs(lane.left_m) < allowance_m_;
  if (scan != nullptr && has_room && (left > settings_.ending_m || shift_m != 0.0))
    return byGodzila(segment, at, *scan, shift_m);
  return byPlan(segment, at);
}

Velocity Follow::turnOn(const Motion& motion, const Pose& at, double tolerance_m) const {
  Velocity velocity = holdAt({motion.from.x, motion.from.y, at.yaw}, at, settings_.hold, limits_);
  const double off = distance(at.position(), motion.from.position());
  const double share = std::clamp(2.0 - off / tolerance_m, 0.0, 1.0);  // first the place, then the turn
  velocity.turn_radps = share * std::clamp(settings_.hold.heading_gain * (motion.angle_rad - turned_rad_),
                                           -limits_.turn_radps, limits_.turn_radps);
  return velocity;
}

Velocity Follow::byPlan(const Segment& segment, const Pose& at) const {
  const Motion& motion = segment.motion;
  const OnLane lane = onLane(motion, at);
  const LaneError error = errorOf(lane, segment.closeness.clearance_m);
  const double left = length(motion) - lane.along_m;
  if (left <= 0.0) return holdAt({motion.to.x, motion.to.y, motion.to.yaw}, at, settings_.hold, limits_);
  const bool is_tight = segment.closeness.clearance_m < settings_.roomy_m;
  const double top = robot_->modes[motion.mode].speed(motion.sense) * (is_tight ? settings_.slow_share : 1.0);
  constexpr double kCreep_mps = 0.004;
  const double speed = std::min(top, settings_.hold.gain * left + kCreep_mps);
  return alongLane(angleOf(motion.sense), speed, error, settings_.hold, limits_);
}

Velocity Follow::byGodzila(const Segment& segment, const Pose& at, const Scan& scan, double shift_m) const {
  const Motion& motion = segment.motion;
  const double ahead = std::min(onLane(motion, at).along_m + settings_.ahead_m, length(motion));
  const Point goal = pointAlong(shifted(motion, shift_m), ahead);
  const double facing = angleOf(motion.sense);
  const auto optimum = optimum_.of(scan, bearingOf(goal, at), facing);
  return velocityTowards(optimum, settings_.godzila, limits_, facing);
}

bool Follow::isDone(const Segment& segment, const Pose& at) const {
  const Motion& motion = segment.motion;
  const LaneError error = errorOf({}, segment.closeness.clearance_m);
  if (motion.kind == MotionKind::kTurn)
    return std::abs(motion.angle_rad - turned_rad_) < settings_.reached_rad;
  const OnLane lane = onLane(motion, at);
  return lane.along_m > length(motion) - settings_.reached_m && std::abs(lane.left_m) < error.tolerance_m &&
         std::abs(lane.turned_rad) < error.tolerance_rad;
}

bool Follow::isAstray(const Segment& segment, const Pose& at) const {
  constexpr double kFar_m = 0.25;
  const Motion& motion = segment.motion;
  if (motion.kind != MotionKind::kTranslate) return distance(at.position(), motion.from.position()) > kFar_m;
  const OnLane lane = onLane(motion, at);
  return std::abs(lane.left_m) > allowance_m_ + kFar_m || lane.along_m < -kFar_m ||
         lane.along_m > length(motion) + kFar_m;
}

}  // namespace underway
