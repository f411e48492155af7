#include "tests/judge/kinematics.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace judge {
namespace {

constexpr double kStep_m = 1e-9;
constexpr double kAngle_rad = 1e-9;
constexpr double kGoal_m = 0.01;
constexpr double kGoal_rad = 0.02;
constexpr double kTime_s = 1e-6;
constexpr double kLength_m = 1e-6;

struct Judging {
  const RobotFile& robot;
  Verdict& verdict;
  std::string where;

  template <class... Parts>
  void complain(const Parts&... parts) const {
    std::ostringstream sentence;
    sentence.precision(12);
    sentence << where << ": ";
    (sentence << ... << parts);
    verdict.violations.push_back(sentence.str());
  }
};

double directionOf(const std::string& sense) {
  constexpr double kPi = std::numbers::pi;
  static const std::map<std::string, double> kDirections{
      {"forward", 0.0}, {"backward", kPi}, {"left", kPi / 2.0}, {"right", -kPi / 2.0}};
  return kDirections.at(sense);
}

/// The part of a translation along its sense, and the part across it.
Vec2 alongAndAcross(const Segment& segment) {
  return rotated(segment.to.position() - segment.from.position(),
                 -(segment.from.yaw + directionOf(segment.sense)));
}

double lengthOf(const Segment& segment) {
  if (segment.kind == "translate") return norm(segment.to.position() - segment.from.position());
  if (segment.kind == "arc")
    return std::abs(segment.angle_rad) * norm(segment.from.position() - segment.center);
  return 0.0;
}

double speedOf(const Mode& mode, const std::string& sense) {
  const auto found = mode.speed_mps.find(sense);
  return found == mode.speed_mps.end() ? 0.0 : found->second;
}

void judgeDuration(const Segment& segment, double expected_s, const Judging& judging) {
  if (!(std::abs(segment.duration_s - expected_s) <= kTime_s))
    judging.complain("duration_s is ", segment.duration_s, " and should be ", expected_s);
}

void judgeTranslation(const Segment& segment, const Mode& mode, const Judging& judging) {
  const double speed = speedOf(mode, segment.sense);
  if (!(speed > 0.0)) return judging.complain("mode ", segment.mode, " cannot move ", segment.sense);
  if (segment.to.yaw != segment.from.yaw) judging.complain("the yaw changes in a translation");
  const Vec2 step = alongAndAcross(segment);
  if (step.x < -kStep_m || std::abs(step.y) > kStep_m)
    judging.complain("the step is ", step.x, " m along its sense and ", step.y, " m across it");
  judgeDuration(segment, lengthOf(segment) / speed, judging);
}

void judgeTurnedYaw(const Segment& segment, const Judging& judging) {
  const double missed = wrapped(segment.from.yaw + segment.angle_rad - segment.to.yaw);
  if (std::abs(missed) > kAngle_rad)
    judging.complain("angle_rad ", segment.angle_rad, " misses the yaw it leads to by ", missed, " rad");
}

void judgeTurn(const Segment& segment, const Mode& mode, const Judging& judging) {
  if (!(mode.turn_speed_radps > 0.0)) return judging.complain("mode ", segment.mode, " cannot turn");
  if (segment.to.position() != segment.from.position()) judging.complain("the position changes in a turn");
  judgeTurnedYaw(segment, judging);
  judgeDuration(segment, std::abs(segment.angle_rad) / mode.turn_speed_radps, judging);
}

/// An arc walks forward and turns at once; it can be no faster than either.
void judgeArc(const Segment& segment, const Mode& mode, const Judging& judging) {
  const double speed = speedOf(mode, "forward");
  if (!(mode.turn_speed_radps > 0.0) || !(speed > 0.0))
    return judging.complain("mode ", segment.mode, " cannot walk arcs");
  judgeTurnedYaw(segment, judging);
  const Vec2 arm = segment.from.position() - segment.center;
  const Vec2 end = segment.center + rotated(arm, segment.angle_rad);
  if (norm(end - segment.to.position()) > kStep_m) judging.complain("the arc does not end at `to`");
  const Vec2 heading = rotated({1.0, 0.0}, segment.from.yaw);
  if (std::abs(dot(arm, heading)) > kStep_m || cross(arm, heading) * segment.angle_rad < 0.0)
    judging.complain("the arc does not begin straight ahead");
  const double least_s =
      std::max(lengthOf(segment) / speed, std::abs(segment.angle_rad) / mode.turn_speed_radps);
  if (segment.duration_s < least_s - kTime_s)
    judging.complain("duration_s is ", segment.duration_s, " and cannot be below ", least_s);
}

void judgeSwitch(const Segment& segment, const Judging& judging) {
  const Switch* change = judging.robot.findSwitch(segment.mode, segment.to_mode);
  if (change == nullptr)
    return judging.complain("the robot cannot switch from ", segment.mode, " to ", segment.to_mode);
  const Vec2 end = placed(segment.from, change->displacement.position());
  if (norm(end - segment.to.position()) > kStep_m ||
      std::abs(wrapped(segment.from.yaw + change->displacement.yaw - segment.to.yaw)) > kAngle_rad)
    judging.complain("`to` is not `from` moved by the switch's displacement");
  judgeDuration(segment, change->duration_s, judging);
}

void judgeMotion(const Segment& segment, const Judging& judging) {
  const Mode* mode = judging.robot.findMode(segment.mode);
  if (mode == nullptr) return judging.complain("the robot has no mode ", segment.mode);
  if (segment.kind == "translate") return judgeTranslation(segment, *mode, judging);
  if (segment.kind == "turn") return judgeTurn(segment, *mode, judging);
  if (segment.kind == "arc") return judgeArc(segment, *mode, judging);
  judgeSwitch(segment, judging);
}

void judgeEnd(const Document& document, const Pose& end, const std::string& end_mode,
              const Judging& judging) {
  const double off_m = norm(end.position() - document.goal);
  if (!(off_m <= kGoal_m)) judging.complain("ends ", off_m, " m from the goal");
  if (document.goal_yaw && !(std::abs(wrapped(end.yaw - *document.goal_yaw)) <= kGoal_rad))
    judging.complain("ends ", wrapped(end.yaw - *document.goal_yaw), " rad from the goal's yaw");
  if (end_mode != document.goal_mode)
    judging.complain("ends in mode ", end_mode, ", not in the goal's mode ", document.goal_mode);
}

}  // namespace

void judgeKinematics(const Document& document, const Scene& scene, const RobotFile& robot, Verdict& verdict) {
  Judging judging{robot, verdict, "plan"};
  if (document.robot != robot.name)
    judging.complain("is of robot ", document.robot, ", judged as ", robot.name);
  if (document.map != scene.name) judging.complain("is of map ", document.map, ", judged on ", scene.name);
  for (const std::string& mode : {document.start_mode, document.goal_mode})
    if (robot.findMode(mode) == nullptr) judging.complain("the robot has no mode \"", mode, "\"");
  Pose at = document.start;
  std::string mode = document.start_mode;
  double time_s = 0.0;
  double length_m = 0.0;
  for (std::size_t i = 0; i < document.segments.size(); ++i) {
    const Segment& segment = document.segments[i];
    judging.where = "segment " + std::to_string(i);
    if (segment.from != at) judging.complain("does not start where the last one ended, bit for bit");
    if (segment.mode != mode) judging.complain("is in mode ", segment.mode, ", reached in mode ", mode);
    judgeMotion(segment, judging);
    at = segment.to;
    mode = segment.to_mode;
    time_s += segment.duration_s;
    length_m += lengthOf(segment);
  }
  judging.where = "plan";
  judgeEnd(document, at, mode, judging);
  if (!(std::abs(document.total_time_s - time_s) <= kTime_s))
    judging.complain("total_time_s is ", document.total_time_s, ", the durations' sum is ", time_s);
  if (!(std::abs(document.length_m - length_m) <= kLength_m))
    judging.complain("length_m is ", document.length_m, ", the translated lengths' sum is ", length_m);
}

}  // namespace judge
