#include "geometry/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway {
namespace {

constexpr double kLowestSeen_m = 0.005;  // what is flatter than this is floor to every mode (formats: 'Free')

/// Before any sweep.
const BodyBox& bodyOf(const Robot& robot, const Motion& motion) {
  return motion.kind == MotionKind::kSwitch ? robot.findSwitch(motion.mode, motion.to_mode)->body_m
                                            : robot.modes[motion.mode].body_m;
}

/// Further along a sense, and wider to both sides.
void extend(Prism& box, Sense sense, double length_m, double widening_m) {
  const bool along_x = sense == Sense::kForward || sense == Sense::kBackward;
  const bool ahead = sense == Sense::kForward || sense == Sense::kLeft;
  Range& along = along_x ? box.x : box.y;
  Range& across = along_x ? box.y : box.x;
  (ahead ? along.max : along.min) += ahead ? length_m : -length_m;
  across = across.grown(widening_m);
}

}  // namespace

std::array<Point, 4> Prism::footprint() const {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  const auto at = [&](double px, double py) {
    return Point{frame.x + c * px - s * py, frame.y + s * px + c * py};
  };
  return {at(x.min, y.min), at(x.max, y.min), at(x.max, y.max), at(x.min, y.max)};
}

Range slabOf(const Robot& robot, const Motion& motion, double floor_z_m) {
  const double step_over =
      std::min(robot.modes[motion.mode].step_over_m, robot.modes[motion.to_mode].step_over_m);
  return {floor_z_m + std::max(step_over, kLowestSeen_m), floor_z_m + bodyOf(robot, motion).z.max};
}

Prism sweptBox(const Robot& robot, const Motion& motion, Range slab) {
  const BodyBox& body = bodyOf(robot, motion);
  Prism box{motion.from, body.x, body.y, slab};
  if (motion.kind == MotionKind::kTranslate) {
    const double travelled = length(motion);
    extend(box, motion.sense, travelled, travelled * robot.modes[motion.mode].drift_m_per_m);
  }
  return box;
}

Prism sweptBox(const Robot& robot, const Motion& motion, double floor_z_m) {
  return sweptBox(robot, motion, slabOf(robot, motion, floor_z_m));
}

double sweptAngle(const Motion& motion) {
  constexpr double kRevolution = 2.0 * std::numbers::pi;
  return std::clamp(motion.angle_rad, -kRevolution, kRevolution);
}

double reachOf(const BodyBox& body) {
  return std::hypot(std::max(-body.x.min, body.x.max), std::max(-body.y.min, body.y.max));
}

}  // namespace underway
