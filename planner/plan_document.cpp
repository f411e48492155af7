#include "planner/plan_document.hpp"

#include <nlohmann/json.hpp>

namespace underway {
namespace {

// Keeps the keys in the order they are written here, which is the order of the format.
using Json = nlohmann::ordered_json;

Json jsonOf(const Pose& pose) { return {{"x", pose.x}, {"y", pose.y}, {"yaw", pose.yaw}}; }

Json jsonOf(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json jsonOf(const std::optional<Nearest>& nearest) {
  if (!nearest) return nullptr;
  return {{"id", nearest->id}, {"x", nearest->at.x}, {"y", nearest->at.y}};
}

/// A mode that has no name here, since the robot could not be read, is written as "".
std::string modeName(const PlanDocument& document, ModeId id) {
  return id < document.mode_names.size() ? document.mode_names[id] : std::string();
}

Json jsonOf(const PlanDocument& document, const Segment& segment) {
  const Motion& motion = segment.motion;
  Json json{{"kind", name(motion.kind)}, {"mode", modeName(document, motion.mode)}};
  if (motion.kind == MotionKind::kTranslate) json["sense"] = name(motion.sense);
  if (motion.kind == MotionKind::kSwitch) json["to_mode"] = modeName(document, motion.to_mode);
  if (motion.kind == MotionKind::kTurn) json["angle_rad"] = motion.angle_rad;
  json["from"] = jsonOf(motion.from);
  json["to"] = jsonOf(motion.to);
  json["duration_s"] = segment.duration_s;
  json["clearance_m"] = segment.closeness.clearance_m;
  json["headroom_m"] = jsonOf(segment.closeness.headroom_m);
  json["nearest"] = jsonOf(segment.closeness.nearest);
  return json;
}

Json jsonOf(const Blocking& blocking) {
  return {{"obstacle", blocking.obstacle},
          {"mode", blocking.mode},
          {"of", blocking.of},
          {"needs_m", blocking.needs_m},
          {"has_m", blocking.has_m}};
}

Json jsonOf(const PlanStats& stats) {
  return {{"nodes", stats.nodes},       {"edges", stats.edges},       {"batches", stats.batches},
          {"build_ms", stats.build_ms}, {"query_us", stats.query_us}, {"certify_us", stats.certify_us}};
}

Json jsonOf(const Goal& goal) { return {{"x", goal.at.x}, {"y", goal.at.y}, {"yaw", jsonOf(goal.yaw)}}; }

std::string messageOf(const PlanDocument& document) {
  if (!document.answer) return document.answer.error().message;
  return document.choice ? document.choice->why : std::string();
}

/// All goals that would have done, and which of them it is.
void addGoals(const PlanDocument& document, const std::vector<Goal>& goals, Json& json) {
  if (document.answer) json["goal_index"] = document.answer->goal_index;
  json["goals"] = Json::array();
  for (const Goal& goal : goals) {
    json["goals"].push_back(jsonOf(goal));
    json["goals"].back()["mode"] = modeName(document, goal.mode);
  }
}

/// What was asked, of which map and robot: the same for a plan and for a failure.
Json headOf(const PlanDocument& document) {
  const Request& request = document.request;
  const bool ok = document.answer.has_value();
  const std::vector<Goal> goals = goalsOf(request);
  // "goal" is the one that the plan leads to, for readers that know of one only.
  const Goal& goal = goals.at(ok ? document.answer->goal_index : 0);
  Json json{{"status", ok ? std::string_view("ok") : name(document.answer.error().code)},
            {"message", messageOf(document)},
            {"policy", name(request.policy)},
            {"max_detour", request.max_detour},
            {"robot", document.robot_name},
            {"map", document.map_name},
            {"revision", document.revision},
            {"world_hash", document.world_hash},
            {"robot_hash", document.robot_hash},
            {"seed", document.seed},
            {"start", jsonOf(request.start)},
            {"start_mode", modeName(document, request.start_mode)},
            {"goal", jsonOf(goal)},
            {"goal_mode", modeName(document, goal.mode)}};
  if (goals.size() > 1) addGoals(document, goals, json);
  if (ok && document.choice) json["is_new"] = document.choice->is_new;
  return json;
}

}  // namespace

std::string toJson(const PlanDocument& document) {
  // A failure has no times, lengths or statistics: they are written as 0, so that the fields are always
  // there.
  static const Plan kNoPlan;
  const Plan& plan = document.answer ? *document.answer : kNoPlan;
  Json json = headOf(document);
  json["total_time_s"] = plan.total_time_s;
  json["length_m"] = plan.length_m;
  json["segments"] = Json::array();
  for (const Segment& segment : plan.segments) json["segments"].push_back(jsonOf(document, segment));
  if (!document.answer) {
    json["blocking"] = Json::array();
    for (const Blocking& blocking : document.answer.error().blocking)
      json["blocking"].push_back(jsonOf(blocking));
  }
  json["stats"] = jsonOf(plan.stats);
  // Names come from files and may hold any bytes. A number that is not finite becomes null: for max_detour
  // that is "no limit"; elsewhere only a fault of ours could bring it here, and the reader refuses it.
  // Neither may stop a failure from being told.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace underway
