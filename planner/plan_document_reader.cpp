#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "planner/json_reader.hpp"
#include "planner/plan_document.hpp"

namespace underway {
namespace {

constexpr std::size_t kLargestText_bytes = 64U << 20U;
constexpr std::size_t kMostSegments = 100'000;
constexpr std::size_t kMostBlocking = 10'000;
constexpr double kLargestAngle_rad = 1e6;
constexpr double kLargestTime_s = 1e9;
constexpr double kLargestStat = 1e15;
constexpr std::uint64_t kAnyCount = std::numeric_limits<std::uint64_t>::max();

Pose readPose(const JsonReader& json) {
  return {json["x"].number(World::kLargest_m), json["y"].number(World::kLargest_m),
          json["yaw"].number(kLargestAngle_rad)};
}

/// Text of the document as a sentence shows it: quoted, and not longer than a line has room for.
std::string quoted(const std::string& text) {
  constexpr std::size_t kShown = 40;
  return '"' + (text.size() <= kShown ? text : text.substr(0, kShown) + "...") + '"';
}

/// The value that is called so; refused, and the first one taken, when none is.
template <class Value, std::size_t N>
Value readNamed(const JsonReader& json, const std::array<Value, N>& values, std::string_view what) {
  const std::string text = json.text();
  const auto found =
      std::find_if(values.begin(), values.end(), [&](Value value) { return name(value) == text; });
  if (found != values.end()) return *found;
  json.refuse("is " + quoted(text) + ", which is no " + std::string(what));
  return values.front();
}

ModeId readMode(const JsonReader& json, const Robot& robot) {
  const std::string text = json.text();
  if (const std::optional<ModeId> mode = robot.findMode(text)) return *mode;
  json.refuse("is " + quoted(text) + ", which is no mode of robot " + quoted(robot.name));
  return 0;
}

/// A failure may be about a mode that the robot does not have: its name is kept as it was written.
ModeId readAnyMode(const JsonReader& json, std::vector<std::string>& mode_names) {
  const std::string text = json.text();
  const auto found = std::find(mode_names.begin(), mode_names.end(), text);
  if (found == mode_names.end())
    return static_cast<ModeId>((mode_names.push_back(text), mode_names.size() - 1));
  return static_cast<ModeId>(found - mode_names.begin());
}

Segment readSegment(const JsonReader& json, const Robot& robot) {
  static constexpr std::array kKinds{MotionKind::kTranslate, MotionKind::kTurn, MotionKind::kSwitch};
  Segment segment;
  Motion& motion = segment.motion;
  motion.kind = readNamed(json["kind"], kKinds, "kind of segment");
  motion.mode = readMode(json["mode"], robot);
  motion.to_mode = motion.mode;
  if (motion.kind == MotionKind::kTranslate) motion.sense = readNamed(json["sense"], kSenses, "sense");
  if (motion.kind == MotionKind::kSwitch) motion.to_mode = readMode(json["to_mode"], robot);
  if (motion.kind == MotionKind::kTurn) motion.angle_rad = json["angle_rad"].number(kLargestAngle_rad);
  motion.from = readPose(json["from"]);
  motion.to = readPose(json["to"]);
  segment.duration_s = json["duration_s"].number(kLargestTime_s);
  segment.closeness.clearance_m = json["clearance_m"].number(World::kLargest_m);
  segment.closeness.headroom_m = json["headroom_m"].numberOrNull(World::kLargest_m);
  if (const JsonReader nearest = json["nearest"]; !nearest.isNull())
    segment.closeness.nearest =
        Nearest{nearest["id"].text(),
                {nearest["x"].number(World::kLargest_m), nearest["y"].number(World::kLargest_m)}};
  return segment;
}

PlanStats readStats(const JsonReader& json) {
  return {json["nodes"].count(kAnyCount),
          json["edges"].count(kAnyCount),
          static_cast<std::uint32_t>(json["batches"].count(std::numeric_limits<std::uint32_t>::max())),
          json["build_ms"].number(kLargestStat),
          json["query_us"].number(kLargestStat),
          json["certify_us"].number(kLargestStat)};
}

Plan readPlan(const JsonReader& json, const Robot& robot, const Pose& start) {
  Plan plan;
  const JsonReader segments = json["segments"];
  const std::size_t count = segments.size(kMostSegments);
  for (std::size_t i = 0; i < count; ++i) plan.segments.push_back(readSegment(segments.element(i), robot));
  plan.total_time_s = json["total_time_s"].number(kLargestTime_s);
  plan.length_m = json["length_m"].number(kLargestStat);
  plan.goal = plan.segments.empty() ? start : plan.segments.back().motion.to;
  plan.stats = readStats(json["stats"]);
  return plan;
}

Error readFailure(const JsonReader& json, ErrorCode code, std::string message) {
  Error error{code, std::move(message), {}};
  if (json["segments"].size(kMostSegments) != 0)
    json["segments"].refuse("must be empty unless status is \"ok\"");
  const JsonReader blocking = json["blocking"];
  const std::size_t count = blocking.size(kMostBlocking);
  for (std::size_t i = 0; i < count; ++i) {
    const JsonReader one = blocking.element(i);
    error.blocking.push_back({one["obstacle"].text(), one["mode"].text(), one["of"].text(),
                              one["needs_m"].number(World::kLargest_m),
                              one["has_m"].number(World::kLargest_m)});
  }
  return error;
}

/// Without its mode.
Goal readGoal(const JsonReader& json) {
  return {{json["x"].number(World::kLargest_m), json["y"].number(World::kLargest_m)},
          json["yaw"].numberOrNull(kLargestAngle_rad)};
}

Request readRequest(const JsonReader& json) {
  static constexpr std::array kPolicies{Policy::kPriority, Policy::kFastest, Policy::kSafest};
  Request request;
  request.policy = readNamed(json["policy"], kPolicies, "policy");
  // Plans of other programs need not say it. No limit is written as null, since JSON has no infinity.
  if (json.has("max_detour"))
    request.max_detour =
        json["max_detour"].numberOrNull(kLargestStat).value_or(std::numeric_limits<double>::infinity());
  request.start = readPose(json["start"]);
  request = withGoals(std::move(request), {readGoal(json["goal"])});
  return request;
}

/// The goals of a document that has several, `goal` being one of them. `mode_of` reads a mode.
template <class ModeOf>
void readGoals(const JsonReader& json, const ModeOf& mode_of, PlanDocument& document) {
  const JsonReader goals = json["goals"];
  const std::size_t count = goals.size(kMostGoals);
  if (count == 0) goals.refuse("must hold one goal at least");
  std::vector<Goal> all(std::max<std::size_t>(count, 1));
  for (std::size_t i = 0; i < count; ++i) {
    all[i] = readGoal(goals.element(i));
    all[i].mode = mode_of(goals.element(i)["mode"]);
  }
  if (document.answer) {
    const Goal led_to = goalsOf(document.request).front();
    const std::uint64_t index = json["goal_index"].count(all.size() - 1);
    if (index < all.size() && all[index] != led_to) json["goal"].refuse("is not the goal of that index");
    document.answer->goal_index = static_cast<std::uint32_t>(index);
  }
  document.request = withGoals(std::move(document.request), all);
}

PlanDocument readDocument(const JsonReader& json, const Robot& robot) {
  PlanDocument document;
  document.request = readRequest(json);
  document.robot_name = json["robot"].text();
  for (const Mode& mode : robot.modes) document.mode_names.push_back(mode.name);
  document.map_name = json["map"].text();
  document.revision = json["revision"].count(kAnyCount);
  document.world_hash = json["world_hash"].text();
  document.robot_hash = json["robot_hash"].text();
  document.seed = json["seed"].count(kAnyCount);
  std::string message = json["message"].text();
  if (json["status"].text() == "ok") {
    document.request.start_mode = readMode(json["start_mode"], robot);
    document.request.goal_mode = readMode(json["goal_mode"], robot);
    document.answer = readPlan(json, robot, document.request.start);
    document.answer->revision = document.revision;
    document.answer->world_hash = document.world_hash;
    const auto mode_of = [&](const JsonReader& mode) { return readMode(mode, robot); };
    if (json.has("goals")) readGoals(json, mode_of, document);
    if (json.has("is_new")) document.choice = Choice{json["is_new"].flag(), std::move(message)};
  } else {
    std::array<ErrorCode, kErrorCodeCount> codes;
    for (int i = 0; i < kErrorCodeCount; ++i) codes[i] = static_cast<ErrorCode>(i);
    document.request.start_mode = readAnyMode(json["start_mode"], document.mode_names);
    document.request.goal_mode = readAnyMode(json["goal_mode"], document.mode_names);
    const ErrorCode code = readNamed(json["status"], codes, "status");
    document.answer = tl::unexpected(readFailure(json, code, std::move(message)));
    document.answer.error().revision = document.revision;
    document.answer.error().world_hash = document.world_hash;
    const auto mode_of = [&](const JsonReader& mode) { return readAnyMode(mode, document.mode_names); };
    if (json.has("goals")) readGoals(json, mode_of, document);
  }
  return document;
}

std::string lineOf(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

Expected<nlohmann::json> parse(std::string_view text) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    return fail(ErrorCode::kInvalidRequest, "the plan is not JSON: line " + lineOf(text, error.byte) +
                                                " cannot be read; give a file written by --json");
  } catch (const nlohmann::json::exception&) {  // 1e999 is JSON, but no double
    return fail(ErrorCode::kInvalidRequest, "the plan holds a number that is too large; give finite numbers");
  }
}

}  // namespace

Expected<PlanDocument> planFromJson(std::string_view text, const Robot& robot) {
  if (text.size() > kLargestText_bytes)
    return fail(ErrorCode::kInvalidRequest, "the plan is larger than 64 MB; no plan is");
  const Expected<nlohmann::json> json = parse(text);
  if (!json) return tl::unexpected(json.error());
  Fault fault;
  PlanDocument document = readDocument(JsonReader(*json, fault), robot);
  if (!fault.sentence().empty())
    return fail(ErrorCode::kInvalidRequest, "the plan cannot be read: " + fault.sentence());
  return document;
}

}  // namespace underway
