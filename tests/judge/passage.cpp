#include "tests/judge/passage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace judge {
namespace {

constexpr double kLowestSeen_m = 0.005;                          // what is flatter is floor to every mode
constexpr double kSample_rad = 0.02 * std::numbers::pi / 180.0;  // the turn's own error is then below 0.1 mm

Pose poseAlong(const Segment& segment, double t) {
  if (segment.kind == "switch") return segment.from;  // its box covers the whole motion where it is
  const double yaw = segment.from.yaw + t * segment.angle_rad;
  if (segment.kind == "arc") {
    const Vec2 at = segment.center + rotated(segment.from.position() - segment.center, t * segment.angle_rad);
    return {at.x, at.y, yaw};
  }
  const Vec2 at = segment.from.position() + t * (segment.to.position() - segment.from.position());
  return {at.x, at.y, yaw};
}

std::size_t stepsOf(const Segment& segment) {
  const double radius = segment.kind == "arc" ? norm(segment.from.position() - segment.center) : 0.0;
  const double length_m =
      norm(segment.to.position() - segment.from.position()) + radius * std::abs(segment.angle_rad);
  return 1 +
         static_cast<std::size_t>(std::max(length_m / kSample_m, std::abs(segment.angle_rad) / kSample_rad));
}

}  // namespace

Passage passageOf(const Segment& segment, const Scene& scene, const RobotFile& robot) {
  const Mode& mode = *robot.findMode(segment.mode);
  const bool switches = segment.kind == "switch";
  const Body& body = switches ? robot.findSwitch(segment.mode, segment.to_mode)->body : mode.body;
  const double step_over_m =
      switches ? std::min(mode.step_over_m, robot.findMode(segment.to_mode)->step_over_m) : mode.step_over_m;

  Passage passage;
  passage.course = {body.footprint, [segment](double t) { return poseAlong(segment, t); }, stepsOf(segment)};
  passage.widened = passage.course;
  if (segment.kind == "translate" || segment.kind == "arc") {
    const double length_m = norm(segment.to.position() - segment.from.position());
    const double drift_m = mode.drift_m_per_m * length_m;
    const bool sideways = segment.sense == "left" || segment.sense == "right";
    passage.widened.body = body.footprint.grown(sideways ? drift_m : 0.0, sideways ? 0.0 : drift_m);
  }
  passage.z_min = scene.floor_z_m + std::max(step_over_m, kLowestSeen_m);
  passage.z_max = scene.floor_z_m + body.height_m;
  return passage;
}

Passage standing(const Pose& pose, const std::string& mode, const Scene& scene, const RobotFile& robot) {
  Segment segment;
  segment.kind = "turn";
  segment.mode = segment.to_mode = mode;
  segment.from = segment.to = pose;
  return passageOf(segment, scene, robot);
}

}  // namespace judge
