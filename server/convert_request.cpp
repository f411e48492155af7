#include <algorithm>
#include <cmath>
#include <cstring>

#include "server/convert.hpp"
#include "server/convert_following.hpp"
#include "server/wire_limits.hpp"
#include "server/wire_memory.hpp"

namespace underway {
namespace {

constexpr double kLargestYaw_rad = 1000.0;
constexpr std::int32_t kLongestDeadline_ms = 600'000;

bool isWithin(double value, double largest) { return std::abs(value) <= largest; }  // false for NaN

/// What is wrong with the numbers, or nothing.
std::string faultOfNumbers(const underway_PlanRequest& wire) {
  const std::pair<const char*, double> coordinates[] = {{"start.x_m", wire.start.x_m},
                                                        {"start.y_m", wire.start.y_m},
                                                        {"goal_x_m", wire.goal_x_m},
                                                        {"goal_y_m", wire.goal_y_m}};
  for (const auto& [field, value] : coordinates)
    if (!isWithin(value, World::kLargest_m))
      return std::string(field) + " must be a number from -100000 to 100000 m, not " + std::to_string(value);
  if (!isWithin(wire.start.yaw_rad, kLargestYaw_rad))
    return "start.yaw_rad must be a number from -1000 to 1000 rad";
  if (bitsOf<std::uint8_t>(wire.has_goal_yaw) > 1) return "has_goal_yaw must be 0 or 1";
  if (wire.has_goal_yaw && !isWithin(wire.goal_yaw_rad, kLargestYaw_rad))
    return "goal_yaw_rad must be a number from -1000 to 1000 rad";
  if (!(wire.max_detour >= 1.0))
    return "max_detour must be 1 or more, not " + std::to_string(wire.max_detour);
  if (wire.deadline_ms < 1 || wire.deadline_ms > kLongestDeadline_ms)
    return "deadline_ms must be from 1 to 600000 ms, not " + std::to_string(wire.deadline_ms);
  return {};
}

Expected<ModeId> modeOf(std::string_view field, std::optional<std::string_view> text, const Robot& robot) {
  if (!text) return fail(ErrorCode::kInvalidRequest, std::string(field) + " has no end");
  if (text->empty()) return ModeId{0};
  if (const std::optional<ModeId> mode = robot.findMode(*text)) return *mode;
  std::string known;
  for (const Mode& mode : robot.modes) known += (known.empty() ? "" : ", ") + mode.name;
  return fail(ErrorCode::kInvalidRequest,
              std::string(field) + " is not a mode of robot " + robot.name + ": choose one of " + known);
}

Expected<Policy> policyOf(std::optional<std::string_view> text) {
  if (text && text->empty()) return Policy::kPriority;
  const std::optional<Policy> policy = text ? findPolicy(*text) : std::nullopt;
  if (policy) return *policy;
  return fail(ErrorCode::kInvalidRequest, "policy is not known: choose priority, fastest or safest");
}

/// "goal_x_m must be ..." of another goal; empty if nothing is wrong.
std::string faultOfGoal(const underway_Goal& goal) {
  if (!isWithin(goal.x_m, World::kLargest_m) || !isWithin(goal.y_m, World::kLargest_m))
    return "x_m and y_m must be numbers from -100000 to 100000 m";
  if (bitsOf<std::uint8_t>(goal.has_yaw) > 1) return "has_yaw must be 0 or 1";
  if (goal.has_yaw && !isWithin(goal.yaw_rad, kLargestYaw_rad))
    return "yaw_rad must be a number from -1000 to 1000 rad";
  return {};
}

std::string nameOf(std::string list, std::size_t i) {
  return list.append("[").append(std::to_string(i)).append("]");
}

constexpr const char* kTooManyGoals =
    "other_goals must be 63 at most, beside the first: ask for fewer at once";

/// Returns what is wrong; empty if nothing is.
std::string writeGoals(const std::vector<NamedGoal>& goals, underway_PlanRequest& wire) {
  if (goals.size() >= kMostGoals) return kTooManyGoals;
  const auto all = allocate(wire.other_goals, goals.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const NamedGoal& goal = goals[i];
    all[i] = {goal.at.x, goal.at.y, goal.yaw.has_value(), goal.yaw.value_or(0.0), {}};
    if (!copyText(goal.mode, all[i].mode)) return nameOf("other_goals", i) + ".mode must be a mode's name";
    if (const std::string fault = faultOfGoal(all[i]); !fault.empty())
      return nameOf("other_goals", i) + ": " + fault;
  }
  return {};
}

Expected<std::vector<Goal>> otherGoalsOf(const underway_PlanRequest& wire, const Robot& robot) {
  if (!isCounted(wire.other_goals, kMostGoals - 1)) return fail(ErrorCode::kInvalidRequest, kTooManyGoals);
  std::vector<Goal> goals;
  for (std::size_t i = 0; i < wire.other_goals._length; ++i) {
    const underway_Goal& goal = wire.other_goals._buffer[i];
    if (const std::string fault = faultOfGoal(goal); !fault.empty())
      return fail(ErrorCode::kInvalidRequest, nameOf("other_goals", i) + ": " + fault);
    const Expected<ModeId> mode = modeOf(nameOf("other_goals", i) + ".mode", textOf(goal.mode), robot);
    if (!mode) return tl::unexpected(mode.error());
    goals.push_back({{goal.x_m, goal.y_m}, goal.has_yaw ? std::optional(goal.yaw_rad) : std::nullopt, *mode});
  }
  return goals;
}

}  // namespace

bool isRobotName(std::string_view text) {
  constexpr std::string_view kAllowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  return !text.empty() && text.size() <= 64 && text.find_first_not_of(kAllowed) == std::string_view::npos;
}

RequestId idOf(const underway_RequestId& wire) {
  RequestId id;
  std::copy(std::begin(wire.client), std::end(wire.client), id.client.begin());
  id.sequence = wire.number;
  return id;
}

std::string partitionOf(const WireName& robot) {
  const std::optional<std::string_view> text = textOf(robot);
  return text && isRobotName(*text) ? std::string(*text) : std::string();
}

void FreeRequest::operator()(underway_PlanRequest* request) const {
  dds_sample_free(request, &underway_PlanRequest_desc, DDS_FREE_ALL);
}

Expected<WireRequest> toWire(const RequestId& id, const Question& question) {
  WireRequest request(allocate<underway_PlanRequest>());
  underway_PlanRequest& wire = *request;
  std::copy(id.client.begin(), id.client.end(), std::begin(wire.id.client));
  wire.id.number = id.sequence;
  if (!isRobotName(question.robot) || !copyText(question.robot, wire.robot))
    return fail(ErrorCode::kInvalidRequest, "the robot's name must be 1 to 64 of A-Z a-z 0-9 _ -");
  if (!copyText(question.start_mode, wire.start_mode) || !copyText(question.goal_mode, wire.goal_mode))
    return fail(ErrorCode::kInvalidRequest,
                "start_mode and goal_mode must be names of at most 64 characters");
  (void)copyText(name(question.policy), wire.policy);
  wire.start = {question.start.x, question.start.y, question.start.yaw};
  wire.goal_x_m = question.goal.x;
  wire.goal_y_m = question.goal.y;
  wire.has_goal_yaw = question.goal_yaw.has_value();
  wire.goal_yaw_rad = question.goal_yaw.value_or(0.0);
  wire.max_detour = question.max_detour;
  wire.deadline_ms = static_cast<std::int32_t>(
      std::clamp<std::chrono::milliseconds::rep>(question.deadline.count(), 0, kLongestDeadline_ms + 1));
  wire.kind = static_cast<underway_RequestKind>(question.purpose);
  std::string fault = faultOfNumbers(wire);
  if (fault.empty()) fault = writeGoals(question.other_goals, wire);
  if (fault.empty() && question.purpose != Purpose::kPlan) fault = write(question.followed, wire.following);
  if (!fault.empty()) return fail(ErrorCode::kInvalidRequest, fault);
  return request;
}

Expected<Received> fromWire(const underway_PlanRequest& wire, const Robot& robot) {
  if (partitionOf(wire.robot).empty())
    return fail(ErrorCode::kInvalidRequest, "robot must be 1 to 64 of A-Z a-z 0-9 _ -");
  if (const std::string fault = faultOfNumbers(wire); !fault.empty())
    return fail(ErrorCode::kInvalidRequest, fault);
  const Expected<ModeId> start_mode = modeOf("start_mode", textOf(wire.start_mode), robot);
  if (!start_mode) return tl::unexpected(start_mode.error());
  const Expected<ModeId> goal_mode = modeOf("goal_mode", textOf(wire.goal_mode), robot);
  if (!goal_mode) return tl::unexpected(goal_mode.error());
  const Expected<Policy> policy = policyOf(textOf(wire.policy));
  if (!policy) return tl::unexpected(policy.error());
  Expected<std::vector<Goal>> others = otherGoalsOf(wire, robot);
  if (!others) return tl::unexpected(others.error());

  Received received;
  received.asked.request = {.start = {wire.start.x_m, wire.start.y_m, wire.start.yaw_rad},
                            .start_mode = *start_mode,
                            .goal = {wire.goal_x_m, wire.goal_y_m},
                            .goal_yaw = wire.has_goal_yaw ? std::optional(wire.goal_yaw_rad) : std::nullopt,
                            .goal_mode = *goal_mode,
                            .policy = *policy,
                            .max_detour = wire.max_detour,
                            .other_goals = std::move(*others)};
  received.deadline = std::chrono::milliseconds(wire.deadline_ms);
  if (!read(wire.kind, Purpose::kCheck, received.asked.purpose))
    return fail(ErrorCode::kInvalidRequest, "kind must be PLAN, REPLAN or CHECK");
  if (received.asked.purpose == Purpose::kPlan) return received;
  if (const Expected<void> followed = readFollowing(wire.following, robot, received.asked); !followed)
    return tl::unexpected(followed.error());
  return received;
}

}  // namespace underway
