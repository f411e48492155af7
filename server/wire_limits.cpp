#include "server/wire_limits.hpp"

namespace underway {
namespace {

bool isFinite(const Pose& pose) { return areFinite(pose.x, pose.y, pose.yaw); }

std::string faultOf(const Segment& segment, std::size_t mode_count) {
  const Motion& motion = segment.motion;
  const Closeness& close = segment.closeness;
  if (motion.mode >= mode_count || motion.to_mode >= mode_count) return "a mode that the robot does not have";
  if (!isFinite(motion.from) || !isFinite(motion.to) || !areFinite(motion.angle_rad))
    return "a motion not finite";
  if (!areFinite(segment.duration_s) || segment.duration_s < 0.0) return "an impossible duration";
  if (!areFinite(close.clearance_m) || close.clearance_m < 0.0) return "an impossible clearance";
  if (close.headroom_m && !areFinite(*close.headroom_m)) return "a headroom that is not finite";
  if (close.nearest && !areFinite(close.nearest->at.x, close.nearest->at.y))
    return "a nearest point not finite";
  if (close.nearest && !isCarried(close.nearest->id)) return "an obstacle id longer than 4096 bytes";
  return {};
}

}  // namespace

std::string faultOf(const Plan& plan, std::size_t mode_count) {
  if (plan.segments.size() > kMostSegments) return "the plan has more than 4096 segments";
  for (std::size_t i = 0; i < plan.segments.size(); ++i)
    if (const std::string fault = faultOf(plan.segments[i], mode_count); !fault.empty())
      return "segment " + std::to_string(i) + " has " + fault;
  if (!areFinite(plan.total_time_s, plan.length_m) || plan.total_time_s < 0.0 || plan.length_m < 0.0)
    return "the plan has an impossible time or length";
  const PlanStats& stats = plan.stats;
  if (!isFinite(plan.goal)) return "the plan's goal is not finite";
  if (!areFinite(stats.build_ms, stats.query_us, stats.certify_us))
    return "the plan's statistics are not finite";
  return {};
}

std::string faultOf(const Served& served) {
  if (served.robot.modes.empty() || served.robot.modes.size() > kMostModes)
    return "the robot must have 1 to 16 modes";
  for (const Mode& mode : served.robot.modes)
    if (mode.name.empty() || !isCarried(mode.name, kLongestModeName))
      return "the robot's mode names must have 1 to 64 characters";
  for (const std::string& text : {served.robot.name, served.map_name, served.robot_hash})
    if (!isCarried(text)) return "the names of robot and map must have at most 4096 bytes";
  return {};
}

}  // namespace underway
