#include "server/convert_following.hpp"

#include <cmath>

#include "server/wire_limits.hpp"
#include "server/wire_memory.hpp"

namespace underway {
namespace {

constexpr double kLargestAngle_rad = 1000.0;
constexpr double kLongest_s = 1e5;

bool isPose(const underway_Pose& pose) {
  return std::abs(pose.x_m) <= World::kLargest_m && std::abs(pose.y_m) <= World::kLargest_m &&
         std::abs(pose.yaw_rad) <= kLargestAngle_rad;  // false for NaN
}

underway_Pose wirePose(const Pose& pose) { return {pose.x, pose.y, pose.yaw}; }
Pose poseOf(const underway_Pose& wire) { return {wire.x_m, wire.y_m, wire.yaw_rad}; }

/// What is wrong with the numbers; empty if nothing is.
std::string faultOf(const underway_Following& wire) {
  if (!isCounted(wire.modes, kMostModes) || wire.modes._length == 0)
    return "following.modes must be 1 to 16 names";
  if (!isCounted(wire.steps, kMostSegments) || wire.steps._length == 0)
    return "following.steps must be 1 to 4096 steps of the plan that is followed";
  if (wire.step > wire.steps._length) return "following.step must be one of the steps, counted from 0";
  if (!(wire.done >= 0.0 && wire.done <= 1.0)) return "following.done must be from 0 to 1";
  if (!(wire.least_gain >= 0.0 && wire.least_gain <= 1.0)) return "following.least_gain must be from 0 to 1";
  if (!(wire.least_gain_s >= 0.0 && wire.least_gain_s <= kLongest_s))
    return "following.least_gain_s must be from 0 to 100000 s";
  return {};
}

/// The modes of a robot that names stand for.
Expected<std::vector<ModeId>> modesOf(const underway_Following& wire, const Robot& robot) {
  std::vector<ModeId> modes;
  for (std::size_t i = 0; i < wire.modes._length; ++i) {
    std::string text;
    const bool is_text = read(wire.modes._buffer[i], text);
    const auto mode = is_text ? robot.findMode(text) : std::nullopt;
    if (!mode)
      return fail(ErrorCode::kInvalidRequest, "following.modes[" + std::to_string(i) +
                                                  "] is not a mode of robot " + robot.name +
                                                  ": the plan that is followed is another robot's");
    modes.push_back(*mode);
  }
  return modes;
}

bool read(const underway_Step& wire, const std::vector<ModeId>& modes, Motion& motion) {
  if (!underway::read(wire.kind, MotionKind::kSwitch, motion.kind) ||
      !underway::read(wire.sense, Sense::kRight, motion.sense))
    return false;
  if (wire.mode >= modes.size() || wire.to_mode >= modes.size()) return false;
  if (!isPose(wire.from) || !isPose(wire.to) || !(std::abs(wire.angle_rad) <= kLargestAngle_rad))
    return false;
  motion.mode = modes[wire.mode];
  motion.to_mode = modes[wire.to_mode];
  motion.from = poseOf(wire.from);
  motion.to = poseOf(wire.to);
  motion.angle_rad = wire.angle_rad;
  return true;
}

}  // namespace

std::string write(const Followed& from, underway_Following& to) {
  const auto modes = allocate(to.modes, std::min(from.mode_names.size(), kMostModes));
  for (std::size_t i = 0; i < modes.size(); ++i) modes[i] = wireText(from.mode_names[i]);
  const std::vector<Segment>& segments = from.executing.plan.segments;
  const auto steps = allocate(to.steps, std::min(segments.size(), kMostSegments));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Motion& motion = segments[i].motion;
    steps[i] = {static_cast<underway_MotionKind>(motion.kind),
                motion.mode,
                motion.to_mode,
                static_cast<underway_Sense>(motion.sense),
                wirePose(motion.from),
                wirePose(motion.to),
                motion.angle_rad};
  }
  to.step = static_cast<std::uint32_t>(from.executing.segment);
  to.done = from.executing.done;
  to.least_gain = from.least_gain;
  to.least_gain_s = from.least_gain_s;
  if (segments.size() > kMostSegments) return "following.steps must be 4096 at most";
  return faultOf(to);
}

Expected<void> readFollowing(const underway_Following& wire, const Robot& robot, Asked& asked) {
  if (std::string fault = faultOf(wire); !fault.empty())
    return fail(ErrorCode::kInvalidRequest, std::move(fault));
  const Expected<std::vector<ModeId>> modes = modesOf(wire, robot);
  if (!modes) return tl::unexpected(modes.error());
  std::vector<Segment> segments(wire.steps._length);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!read(wire.steps._buffer[i], *modes, segments[i].motion))
      return fail(ErrorCode::kInvalidRequest,
                  "following.steps[" + std::to_string(i) + "] holds what no step of a plan does");
    segments[i].duration_s = duration(robot, segments[i].motion);
  }
  const Pose start = segments.front().motion.from;
  asked.executing = {timedPlan(std::move(segments), start), wire.step, wire.done};
  asked.reluctance.share = wire.least_gain;
  asked.reluctance.least_s = wire.least_gain_s;
  return {};
}

}  // namespace underway
