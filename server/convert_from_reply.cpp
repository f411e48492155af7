#include <algorithm>
#include <cstring>

#include "server/convert.hpp"
#include "server/wire_limits.hpp"
#include "server/wire_memory.hpp"

namespace underway {
namespace {

// Each reader returns false at the first thing that is wrong.
using underway::read;

Pose poseOf(const underway_Pose& wire) { return {wire.x_m, wire.y_m, wire.yaw_rad}; }

bool read(const underway_Segment& wire, Segment& segment) {
  Motion& motion = segment.motion;
  bool has_nearest = false;
  bool has_headroom = false;
  Nearest nearest{{}, {wire.nearest_x_m, wire.nearest_y_m}};
  if (!read(wire.kind, MotionKind::kSwitch, motion.kind) || !read(wire.sense, Sense::kRight, motion.sense) ||
      !read(wire.has_nearest, has_nearest) || !read(wire.has_headroom, has_headroom) ||
      !read(wire.nearest_id, nearest.id))
    return false;
  motion.mode = wire.mode;
  motion.to_mode = wire.to_mode;
  motion.from = poseOf(wire.from);
  motion.to = poseOf(wire.to);
  motion.angle_rad = wire.angle_rad;
  segment.duration_s = wire.duration_s;
  segment.closeness.clearance_m = wire.clearance_m;
  if (has_nearest) segment.closeness.nearest = std::move(nearest);
  if (has_headroom) segment.closeness.headroom_m = wire.headroom_m;
  return true;
}

bool read(const underway_PlanReply& wire, std::size_t mode_count, Plan& plan) {
  if (!isCounted(wire.segments, kMostSegments)) return false;
  plan.segments.resize(wire.segments._length);
  for (std::size_t i = 0; i < plan.segments.size(); ++i)
    if (!read(wire.segments._buffer[i], plan.segments[i])) return false;
  plan.total_time_s = wire.total_time_s;
  plan.length_m = wire.length_m;
  plan.goal = poseOf(wire.goal);
  plan.goal_index = wire.goal_index;
  plan.revision = wire.revision;
  const underway_PlanStats& stats = wire.stats;
  plan.stats = {stats.nodes, stats.edges, stats.batches, stats.build_ms, stats.query_us, stats.certify_us};
  return read(wire.world_hash, plan.world_hash) && faultOf(plan, mode_count).empty();
}

bool read(const underway_PlanReply& wire, Error& error) {
  if (!read(wire.code, ErrorCode::kInternal, error.code) || !read(wire.message, error.message)) return false;
  if (!isCounted(wire.blocking, kMostBlocking)) return false;
  error.revision = wire.revision;
  if (!read(wire.world_hash, error.world_hash)) return false;
  error.blocking.resize(wire.blocking._length);
  for (std::size_t i = 0; i < error.blocking.size(); ++i) {
    const underway_Blocking& from = wire.blocking._buffer[i];
    Blocking& to = error.blocking[i];
    to.needs_m = from.needs_m;
    to.has_m = from.has_m;
    if (!read(from.obstacle, to.obstacle) || !read(from.mode, to.mode) || !read(from.of, to.of) ||
        !areFinite(to.needs_m, to.has_m))
      return false;
  }
  return true;
}

bool read(const underway_PlanReply& wire, PlanDocument& document) {
  if (!isCounted(wire.modes, kMostModes) || wire.modes._length == 0) return false;
  document.mode_names.resize(wire.modes._length);
  for (std::size_t i = 0; i < document.mode_names.size(); ++i)
    if (!read(wire.modes._buffer[i], document.mode_names[i])) return false;
  document.revision = wire.revision;
  document.seed = wire.seed;
  return read(wire.robot_model, document.robot_name) && read(wire.map_name, document.map_name) &&
         read(wire.world_hash, document.world_hash) && read(wire.robot_hash, document.robot_hash);
}

bool readAnswer(const underway_PlanReply& wire, PlanDocument& document) {
  bool ok = false;
  if (!read(wire.ok, ok)) return false;
  Plan plan;
  Error error;
  if (ok ? !read(wire, document.mode_names.size(), plan) : !read(wire, error)) return false;
  if (ok)
    document.answer = std::move(plan);
  else
    document.answer = tl::unexpected(std::move(error));
  bool has_choice = false;
  Choice choice;
  if (!read(wire.has_choice, has_choice) || !read(wire.is_new, choice.is_new) ||
      !read(wire.message, choice.why))
    return false;
  if (ok && has_choice) document.choice = std::move(choice);
  return true;
}

std::optional<ModeId> findMode(const std::vector<std::string>& names, const std::string& mode) {
  if (mode.empty()) return ModeId{0};
  const auto found = std::find(names.begin(), names.end(), mode);
  if (found == names.end()) return std::nullopt;
  return static_cast<ModeId>(found - names.begin());
}

/// A question in the server's modes; empty if it names others.
std::optional<Request> requestOf(const Question& question, const std::vector<std::string>& modes) {
  const std::optional<ModeId> start_mode = findMode(modes, question.start_mode);
  const std::optional<ModeId> goal_mode = findMode(modes, question.goal_mode);
  if (!start_mode || !goal_mode) return std::nullopt;
  Request request{.start = question.start,
                  .start_mode = *start_mode,
                  .goal = question.goal,
                  .goal_yaw = question.goal_yaw,
                  .goal_mode = *goal_mode,
                  .policy = question.policy,
                  .max_detour = question.max_detour};
  for (const NamedGoal& goal : question.other_goals) {
    const std::optional<ModeId> mode = findMode(modes, goal.mode);
    if (!mode) return std::nullopt;
    request.other_goals.push_back({goal.at, goal.yaw, *mode});
  }
  return request;
}

}  // namespace

Expected<PlanDocument> fromWire(const underway_PlanReply& wire, const Question& question) {
  PlanDocument document;
  if (!read(wire, document) || !readAnswer(wire, document) ||
      (document.answer && document.answer->goal_index > question.other_goals.size()))
    return fail(ErrorCode::kInternal,
                "the server's reply is malformed: check that server and client are of the same version");
  const std::optional<Request> request = requestOf(question, document.mode_names);
  if (!request) {
    if (!document.answer) return tl::unexpected(document.answer.error());
    return fail(ErrorCode::kInternal, "the server planned with a mode that it does not have");
  }
  document.request = *request;
  return document;
}

}  // namespace underway
