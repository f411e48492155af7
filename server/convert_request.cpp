#include <algorithm>
#include <cmath>
#include <cstring>

#include "server/convert.hpp"
#include "server/wire_limits.hpp"

namespace underway {
namespace {

constexpr double kLargestYaw_rad = 1000.0;
constexpr std::int32_t kLongestDeadline_ms = 600'000;

/// The text of a bounded string, or nothing if its end is missing.
template <std::size_t N>
std::optional<std::string_view> textOf(const char (&field)[N]) {
  const void* end = std::memchr(field, '\0', N);
  if (end == nullptr) return std::nullopt;
  return std::string_view(field, static_cast<std::size_t>(static_cast<const char*>(end) - field));
}

/// Whether the text fits the field, end and all; a '\0' inside would shorten it on the wire.
template <std::size_t N>
bool copyText(std::string_view text, char (&field)[N]) {
  if (text.size() >= N || text.find('\0') != std::string_view::npos) return false;
  std::copy(text.begin(), text.end(), field);
  return true;
}

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

std::string partitionOf(const underway_PlanRequest& wire) {
  const std::optional<std::string_view> robot = textOf(wire.robot);
  return robot && isRobotName(*robot) ? std::string(*robot) : std::string();
}

Expected<underway_PlanRequest> toWire(const RequestId& id, const Question& question) {
  underway_PlanRequest wire{};
  std::copy(id.client.begin(), id.client.end(), std::begin(wire.id.client));
  wire.id.number = id.sequence;
  if (!isRobotName(question.robot) || !copyText(question.robot, wire.robot))
    return fail(ErrorCode::kInvalidRequest, "the robot's name must be 1 to 64 of A-Z a-z 0-9 _ -");
  if (!copyText(question.start_mode, wire.start_mode) || !copyText(question.goal_mode, wire.goal_mode))
    return fail(ErrorCode::kInvalidRequest,
                "start_mode and goal_mode must be names of at most 64 characters");
  copyText(name(question.policy), wire.policy);
  wire.start = {question.start.x, question.start.y, question.start.yaw};
  wire.goal_x_m = question.goal.x;
  wire.goal_y_m = question.goal.y;
  wire.has_goal_yaw = question.goal_yaw.has_value();
  wire.goal_yaw_rad = question.goal_yaw.value_or(0.0);
  wire.max_detour = question.max_detour;
  wire.deadline_ms = static_cast<std::int32_t>(
      std::clamp<std::chrono::milliseconds::rep>(question.deadline.count(), 0, kLongestDeadline_ms + 1));
  if (const std::string fault = faultOfNumbers(wire); !fault.empty())
    return fail(ErrorCode::kInvalidRequest, fault);
  return wire;
}

Expected<Received> fromWire(const underway_PlanRequest& wire, const Robot& robot) {
  if (partitionOf(wire).empty())
    return fail(ErrorCode::kInvalidRequest, "robot must be 1 to 64 of A-Z a-z 0-9 _ -");
  if (const std::string fault = faultOfNumbers(wire); !fault.empty())
    return fail(ErrorCode::kInvalidRequest, fault);
  const Expected<ModeId> start_mode = modeOf("start_mode", textOf(wire.start_mode), robot);
  if (!start_mode) return tl::unexpected(start_mode.error());
  const Expected<ModeId> goal_mode = modeOf("goal_mode", textOf(wire.goal_mode), robot);
  if (!goal_mode) return tl::unexpected(goal_mode.error());
  const Expected<Policy> policy = policyOf(textOf(wire.policy));
  if (!policy) return tl::unexpected(policy.error());

  Received received;
  received.request = {.start = {wire.start.x_m, wire.start.y_m, wire.start.yaw_rad},
                      .start_mode = *start_mode,
                      .goal = {wire.goal_x_m, wire.goal_y_m},
                      .goal_yaw = wire.has_goal_yaw ? std::optional(wire.goal_yaw_rad) : std::nullopt,
                      .goal_mode = *goal_mode,
                      .policy = *policy,
                      .max_detour = wire.max_detour};
  received.deadline = std::chrono::milliseconds(wire.deadline_ms);
  return received;
}

}  // namespace underway
