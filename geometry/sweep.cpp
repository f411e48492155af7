#include "geometry/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway {
namespace {

constexpr double kLowestSeen_m = 0.005;  // what is flatter than this is floor to every mode (formats: 'Free')

void extend(BodyBox& body, Sense sense, double length_m) {
  switch (sense) {
    case Sense::kForward:
      body.x.max += length_m;
      break;
    case Sense::kBackward:
      body.x.min -= length_m;
      break;
    case Sense::kLeft:
      body.y.max += length_m;
      break;
    case Sense::kRight:
      body.y.min -= length_m;
      break;
  }
}

void widen(BodyBox& body, Sense sense, double by_m) {
  Range& across = sense == Sense::kForward || sense == Sense::kBackward ? body.y : body.x;
  across = across.grown(by_m);
}

BodyBox boxOf(const Robot& robot, const Motion& motion) {
  if (motion.kind == MotionKind::kSwitch) return robot.findSwitch(motion.mode, motion.to_mode)->body_m;
  BodyBox body = robot.modes[motion.mode].body_m;
  if (motion.kind == MotionKind::kTranslate) {
    const double travelled = length(motion);
    extend(body, motion.sense, travelled);
    widen(body, motion.sense, travelled * robot.modes[motion.mode].drift_m_per_m);
  }
  return body;
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
  return {floor_z_m + std::max(step_over, kLowestSeen_m), floor_z_m + boxOf(robot, motion).z.max};
}

Prism sweptBox(const Robot& robot, const Motion& motion, double floor_z_m) {
  const BodyBox body = boxOf(robot, motion);
  return {motion.from, body.x, body.y, slabOf(robot, motion, floor_z_m)};
}

double sweptAngle(const Motion& motion) {
  constexpr double kRevolution = 2.0 * std::numbers::pi;
  return std::clamp(motion.angle_rad, -kRevolution, kRevolution);
}

double reachOf(const BodyBox& body) {
  return std::hypot(std::max(-body.x.min, body.x.max), std::max(-body.y.min, body.y.max));
}

}  // namespace underway
