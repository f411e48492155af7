#include "planner/plan.hpp"

#include <algorithm>
#include <array>

namespace underway {
namespace {

constexpr std::array<std::string_view, 3> kPolicyNames{"priority", "fastest", "safest"};

}  // namespace

std::string_view name(Policy policy) { return kPolicyNames.at(static_cast<std::size_t>(policy)); }

std::optional<Policy> findPolicy(std::string_view name) {
  for (std::size_t i = 0; i < kPolicyNames.size(); ++i)
    if (kPolicyNames[i] == name) return static_cast<Policy>(i);
  return std::nullopt;
}

std::vector<Goal> goalsOf(const Request& request) {
  std::vector<Goal> goals{{request.goal, request.goal_yaw, request.goal_mode}};
  goals.insert(goals.end(), request.other_goals.begin(), request.other_goals.end());
  return goals;
}

Request withGoals(Request request, const std::vector<Goal>& goals) {
  request.goal = goals.front().at;
  request.goal_yaw = goals.front().yaw;
  request.goal_mode = goals.front().mode;
  request.other_goals.assign(goals.begin() + 1, goals.end());
  return request;
}

Plan timedPlan(std::vector<Segment> segments, const Pose& start) {
  Plan plan;
  plan.goal = segments.empty() ? start : segments.back().motion.to;
  for (const Segment& segment : segments) {
    plan.total_time_s += segment.duration_s;
    plan.length_m += length(segment.motion);
  }
  plan.segments = std::move(segments);
  return plan;
}

double leastClearance(const Plan& plan) {
  double least = kEnoughClearance_m;
  for (const Segment& segment : plan.segments) least = std::min(least, segment.closeness.clearance_m);
  return least;
}

}  // namespace underway
