#include "sim/second_judge.hpp"

#include <algorithm>
#include <cmath>

namespace underway::sim {
namespace {

constexpr double kFloor_m = 0.005;  // what is flatter is floor to every mode

/// What the robot is while it moves: of a switch, the box that covers all of it.
Prism bodyIn(const Robot& robot, const Motion& motion, double floor_z_m, double grown_m) {
  const Mode& mode = robot.modes[motion.mode];
  const bool is_switch = motion.kind == MotionKind::kSwitch;
  const BodyBox& box = is_switch ? robot.findSwitch(motion.mode, motion.to_mode)->body_m : mode.body_m;
  const double step_over = std::min(mode.step_over_m, robot.modes[motion.to_mode].step_over_m);
  const Range heights{floor_z_m + std::max(step_over, kFloor_m), floor_z_m + box.z.max};
  return {motion.from, box.x.grown(grown_m), box.y.grown(grown_m), heights.grown(grown_m)};
}

double furthestOf(const Prism& body) {
  return std::hypot(std::max(-body.x.min, body.x.max), std::max(-body.y.min, body.y.max));
}

/// A share of the way along a motion.
Pose poseAt(const Motion& motion, double share) {
  switch (motion.kind) {
    case MotionKind::kTranslate:
      return {std::lerp(motion.from.x, motion.to.x, share), std::lerp(motion.from.y, motion.to.y, share),
              motion.from.yaw};
    case MotionKind::kTurn:
      return {motion.from.x, motion.from.y, motion.from.yaw + share * motion.angle_rad};
    case MotionKind::kSwitch:
      break;
  }
  return motion.from;
}

/// How far a corner goes at most.
double wayOf(const Motion& motion, const Prism& body) {
  if (motion.kind == MotionKind::kTurn) return std::abs(motion.angle_rad) * furthestOf(body);
  return length(motion);
}

}  // namespace

SecondJudge::SecondJudge(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot)
    : world_(std::move(world)),
      robot_(std::move(robot)),
      scene_(std::shared_ptr<const Obstacles>(world_, &world_->obstacles())) {}

bool SecondJudge::touches(const Motion& motion, double grown_m) const {
  Prism body = bodyIn(*robot_, motion, world_->floorZ(), grown_m);
  const Region round = Region::between(motion.from.position(), poseAt(motion, 1.0).position());
  const FclShapes near = scene_.shapesIn(round.grown(furthestOf(body)));
  const auto steps = static_cast<int>(std::ceil(wayOf(motion, body) / kStep_m));
  for (int i = 0; i <= steps; ++i) {
    body.frame = poseAt(motion, steps == 0 ? 0.0 : static_cast<double>(i) / steps);
    if (isOutside(body) || (near.size() > 0 && near.comeWithin(body, 0.0))) return true;
  }
  return false;
}

bool SecondJudge::disputes(const Motion& motion, bool is_free) const {
  if (is_free) return touches(motion, -kTouching_m);
  const double drift_m = robot_->modes[motion.mode].drift_m_per_m * length(motion);
  return !touches(motion, kTouching_m + kStep_m + drift_m);
}

bool SecondJudge::isOutside(const Prism& body) const {
  constexpr double kRounding_m = 1e-9;
  const Bounds& bounds = world_->bounds();
  const double c = std::cos(bounds.corner.yaw);
  const double s = std::sin(bounds.corner.yaw);
  const auto corners = body.footprint();
  return std::any_of(corners.begin(), corners.end(), [&](Point corner) {
    const double dx = corner.x - bounds.corner.x;
    const double dy = corner.y - bounds.corner.y;
    const double x = c * dx + s * dy;
    const double y = c * dy - s * dx;
    return std::max({-x, x - bounds.width_m, -y, y - bounds.height_m}) > kRounding_m;
  });
}

}  // namespace underway::sim
