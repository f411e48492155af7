#include <algorithm>
#include <cstring>
#include <span>

#include "server/convert.hpp"
#include "server/wire_limits.hpp"
#include "server/wire_memory.hpp"

namespace underway {
namespace {

template <class Wire, class Ours>
constexpr bool isMirrored(Wire wire, Ours ours) {
  return static_cast<int>(wire) == static_cast<int>(ours);
}
static_assert(isMirrored(underway_START_IN_COLLISION, ErrorCode::kStartInCollision));
static_assert(isMirrored(underway_GOAL_IN_COLLISION, ErrorCode::kGoalInCollision));
static_assert(isMirrored(underway_START_OUT_OF_BOUNDS, ErrorCode::kStartOutOfBounds));
static_assert(isMirrored(underway_GOAL_OUT_OF_BOUNDS, ErrorCode::kGoalOutOfBounds));
static_assert(isMirrored(underway_NO_PATH_EXISTS, ErrorCode::kNoPathExists));
static_assert(isMirrored(underway_TIMEOUT, ErrorCode::kTimeout));
static_assert(isMirrored(underway_CANCELLED, ErrorCode::kCancelled));
static_assert(isMirrored(underway_BUSY, ErrorCode::kBusy));
static_assert(isMirrored(underway_INVALID_REQUEST, ErrorCode::kInvalidRequest));
static_assert(isMirrored(underway_INVALID_MAP, ErrorCode::kInvalidMap));
static_assert(isMirrored(underway_INVALID_ROBOT, ErrorCode::kInvalidRobot));
static_assert(isMirrored(underway_STALE_REVISION, ErrorCode::kStaleRevision));
static_assert(isMirrored(underway_NO_SERVER, ErrorCode::kNoServer));
static_assert(isMirrored(underway_INTERNAL, ErrorCode::kInternal));
static_assert(isMirrored(underway_INTERNAL, kErrorCodeCount - 1));
static_assert(isMirrored(underway_TRANSLATE, MotionKind::kTranslate) &&
              isMirrored(underway_TURN, MotionKind::kTurn) &&
              isMirrored(underway_SWITCH_MODE, MotionKind::kSwitch));
static_assert(isMirrored(underway_FORWARD, Sense::kForward) &&
              isMirrored(underway_BACKWARD, Sense::kBackward) && isMirrored(underway_LEFT, Sense::kLeft) &&
              isMirrored(underway_RIGHT, Sense::kRight));

underway_Pose wirePose(const Pose& pose) { return {pose.x, pose.y, pose.yaw}; }

void write(const Segment& from, underway_Segment& to) {
  const Motion& motion = from.motion;
  to.kind = static_cast<underway_MotionKind>(motion.kind);
  to.mode = motion.mode;
  to.to_mode = motion.to_mode;
  to.sense = static_cast<underway_Sense>(motion.sense);
  to.from = wirePose(motion.from);
  to.to = wirePose(motion.to);
  to.angle_rad = motion.angle_rad;
  to.duration_s = from.duration_s;
  to.clearance_m = from.closeness.clearance_m;
  const std::optional<Nearest>& nearest = from.closeness.nearest;
  to.has_nearest = nearest.has_value();
  to.nearest_id = wireText(nearest ? nearest->id : std::string());
  to.nearest_x_m = nearest ? nearest->at.x : 0.0;
  to.nearest_y_m = nearest ? nearest->at.y : 0.0;
  to.has_headroom = from.closeness.headroom_m.has_value();
  to.headroom_m = from.closeness.headroom_m.value_or(0.0);
}

void write(const Given& given, underway_PlanReply& reply) {
  const Plan& plan = given.plan;
  reply.ok = true;
  reply.message = wireText(given.choice ? given.choice->why : std::string());
  reply.has_choice = given.choice.has_value();
  reply.is_new = given.choice && given.choice->is_new;
  reply.goal_index = plan.goal_index;
  reply.revision = plan.revision;
  reply.world_hash = wireText(plan.world_hash);
  const auto segments = allocate(reply.segments, plan.segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) write(plan.segments[i], segments[i]);
  reply.total_time_s = plan.total_time_s;
  reply.length_m = plan.length_m;
  reply.goal = wirePose(plan.goal);
  const PlanStats& stats = plan.stats;
  reply.stats = {stats.nodes, stats.edges, stats.batches, stats.build_ms, stats.query_us, stats.certify_us};
}

void write(const Error& error, underway_PlanReply& reply) {
  reply.code = static_cast<underway_ErrorCode>(error.code);
  reply.message = wireText(error.message);
  reply.revision = error.revision;
  reply.world_hash = wireText(error.world_hash);
  std::vector<Blocking> sound = error.blocking;
  std::erase_if(sound, [](const Blocking& one) { return !areFinite(one.needs_m, one.has_m); });
  const auto blocking = allocate(reply.blocking, std::min(sound.size(), kMostBlocking));
  for (std::size_t i = 0; i < blocking.size(); ++i) {
    const Blocking& from = sound[i];
    blocking[i] = {wireText(from.obstacle), wireText(from.mode), wireText(from.of), from.needs_m, from.has_m};
  }
}

}  // namespace

void FreeReply::operator()(underway_PlanReply* reply) const {
  dds_sample_free(reply, &underway_PlanReply_desc, DDS_FREE_ALL);
}

WireReply toWire(const RequestId& id, const Served& served, const Expected<Given>& answer) {
  if (answer) {
    if (const std::string fault = faultOf(answer->plan, served.robot.modes.size()); !fault.empty())
      return toWire(id, served, fail(ErrorCode::kInternal, "the planner's answer cannot be sent: " + fault));
  }
  WireReply reply(allocate<underway_PlanReply>());
  std::copy(id.client.begin(), id.client.end(), std::begin(reply->id.client));
  reply->id.number = id.sequence;
  if (answer)
    write(*answer, *reply);
  else
    write(answer.error(), *reply);
  reply->robot_model = wireText(served.robot.name);
  const auto modes = allocate(reply->modes, served.robot.modes.size());
  for (std::size_t i = 0; i < modes.size(); ++i) modes[i] = wireText(served.robot.modes[i].name);
  reply->map_name = wireText(served.map_name);
  reply->robot_hash = wireText(served.robot_hash);
  reply->seed = served.seed;
  return reply;
}

}  // namespace underway
