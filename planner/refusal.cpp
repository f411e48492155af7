#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/answer.hpp"

namespace underway {
namespace {

constexpr int kHeadings = 72;  // tried at a goal that leaves the heading open

bool isFinite(const Pose& pose) {
  constexpr double kLargestYaw_rad = 1e6;  // beyond, a double no longer holds a heading to 1e-9
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::abs(pose.yaw) <= kLargestYaw_rad;
}

/// The height a place below an obstacle leaves, 0 if the obstacle stands on the floor [m].
double heightBelow(const World& world, const std::string& id) {
  double lowest = INFINITY;
  for (const Vec3& corner : corners(world.obstacles()[*world.obstacles().find(id)].box))
    lowest = std::min(lowest, corner.z);
  return std::max(0.0, lowest - world.floorZ());
}

Error collision(const Checker& checker, ErrorCode code, const std::string& end, ModeId mode,
                const Pose& pose) {
  const std::string& mode_name = checker.robot().modes[mode].name;
  const double height = checker.robot().modes[mode].body_m.z.max;
  Error error{code, {}, {}};
  for (const std::string& id : checker.blockers(stay(mode, pose), 0.0))
    error.blocking.push_back({id, mode_name, "height", height, heightBelow(checker.world(), id)});
  const std::string touched = error.blocking.empty() ? "an obstacle" : error.blocking[0].obstacle;
  error.message = fmt::format(
      "{} ({:.3f} m, {:.3f} m, {:.3f} rad) touches {} in mode {}; move it, or choose another mode", end,
      pose.x, pose.y, pose.yaw, touched, mode_name);
  return error;
}

std::optional<Error> refusalOf(const Checker& checker, const std::string& end, ModeId mode, const Pose& pose,
                               ErrorCode out_of_bounds, ErrorCode in_collision) {
  const Motion standing = stay(mode, pose);
  if (!checker.isInBounds(standing))
    return Error{
        out_of_bounds,
        fmt::format("{} ({:.3f} m, {:.3f} m, {:.3f} rad): the body in mode {} is not wholly inside the map's "
                    "bounds; move it inside",
                    end, pose.x, pose.y, pose.yaw, checker.robot().modes[mode].name),
        {}};
  if (checker.isFree(standing, 0.0)) return std::nullopt;
  return collision(checker, in_collision, end, mode, pose);
}

std::optional<Error> refusalOfGoal(const Checker& checker, const Goal& goal, const std::string& called) {
  const auto refusal_at = [&](double yaw) {
    return refusalOf(checker, called, goal.mode, {goal.at.x, goal.at.y, yaw}, ErrorCode::kGoalOutOfBounds,
                     ErrorCode::kGoalInCollision);
  };
  if (goal.yaw) return refusal_at(*goal.yaw);
  std::optional<Error> first;
  for (int i = 0; i < kHeadings; ++i) {
    const auto refusal = refusal_at(2.0 * std::numbers::pi * i / kHeadings);
    if (!refusal) return std::nullopt;
    // Of headings that fail, a collision says more than a body that sticks out of the map.
    if (!first ||
        (first->code == ErrorCode::kGoalOutOfBounds && refusal->code == ErrorCode::kGoalInCollision))
      first = refusal;
  }
  return first;
}

/// What none of several goals can be stood at for, in a sentence for each of the first few.
Error refusalOfAll(const std::vector<Error>& refused) {
  constexpr std::size_t kMostTold = 4;
  if (refused.size() == 1) return refused.front();
  Error error{refused.front().code, fmt::format("none of the {} goals can be stood at", refused.size()), {}};
  for (std::size_t i = 0; i < std::min(refused.size(), kMostTold); ++i) {
    error.message += (i == 0 ? ": " : "; ") + refused[i].message;
    error.blocking.insert(error.blocking.end(), refused[i].blocking.begin(), refused[i].blocking.end());
  }
  if (refused.size() > kMostTold) error.message += fmt::format("; {} more", refused.size() - kMostTold);
  return error;
}

Expected<std::vector<Goal>> admittedGoals(const Checker& checker, const std::vector<Goal>& goals) {
  std::vector<Goal> admitted;
  std::vector<Error> refused;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (std::find(goals.begin(), goals.begin() + static_cast<std::ptrdiff_t>(i), goals[i]) !=
        goals.begin() + static_cast<std::ptrdiff_t>(i))
      continue;  // asked for already
    const std::string called = goals.size() == 1 ? "goal" : fmt::format("goal {}", i + 1);
    if (auto refusal = refusalOfGoal(checker, goals[i], called))
      refused.push_back(*std::move(refusal));
    else
      admitted.push_back(goals[i]);
  }
  if (admitted.empty()) return tl::unexpected(refusalOfAll(refused));
  return admitted;
}

/// What is wrong with a request whatever the world is like; empty if nothing is.
std::string faultOf(const Request& request, const std::vector<Goal>& goals, std::size_t mode_count) {
  if (!isFinite(request.start))
    return "the start pose must be finite numbers (m, m, rad), the yaw within 1e6";
  if (request.start_mode >= mode_count) return "the start's mode is not one of the robot's";
  if (goals.size() > kMostGoals)
    return fmt::format("a request may have {} goals, this one has {}; ask for fewer at once", kMostGoals,
                       goals.size());
  for (const Goal& goal : goals) {
    if (!isFinite({goal.at.x, goal.at.y, goal.yaw.value_or(0.0)}))
      return "the goal must be finite numbers (m, m, rad), the yaw within 1e6";
    if (goal.mode >= mode_count) return "the goal's mode is not one of the robot's";
  }
  if (!(request.max_detour >= 1.0))
    return "the largest detour must be 1 or more times the fastest plan's time";
  return {};
}

}  // namespace

Expected<Request> admitted(const Checker& checker, const Request& request) {
  const std::vector<Goal> goals = goalsOf(request);
  if (std::string fault = faultOf(request, goals, checker.robot().modes.size()); !fault.empty())
    return fail(ErrorCode::kInvalidRequest, std::move(fault));
  if (auto refused = refusalOf(checker, "start", request.start_mode, request.start,
                               ErrorCode::kStartOutOfBounds, ErrorCode::kStartInCollision))
    return tl::unexpected(*std::move(refused));
  return admittedGoals(checker, goals).map([&](const std::vector<Goal>& some) {
    return withGoals(request, some);
  });
}

}  // namespace underway
