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

Error collision(const Checker& checker, ErrorCode code, const char* end, ModeId mode, const Pose& pose) {
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

std::optional<Error> refusalOf(const Checker& checker, const char* end, ModeId mode, const Pose& pose,
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

std::optional<Error> refusalOfGoal(const Checker& checker, const Request& request) {
  const auto refusal_at = [&](double yaw) {
    return refusalOf(checker, "goal", request.goal_mode, {request.goal.x, request.goal.y, yaw},
                     ErrorCode::kGoalOutOfBounds, ErrorCode::kGoalInCollision);
  };
  if (request.goal_yaw) return refusal_at(*request.goal_yaw);
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

}  // namespace

std::optional<Error> refusal(const Checker& checker, const Request& request) {
  const Pose goal{request.goal.x, request.goal.y, request.goal_yaw.value_or(0.0)};
  const auto invalid = [](std::string message) {
    return Error{ErrorCode::kInvalidRequest, std::move(message), {}};
  };
  if (!isFinite(request.start))
    return invalid("the start pose must be finite numbers (m, m, rad), the yaw within 1e6");
  if (!isFinite(goal)) return invalid("the goal must be finite numbers (m, m, rad), the yaw within 1e6");
  if (request.start_mode >= checker.robot().modes.size())
    return invalid("the start's mode is not one of the robot's");
  if (request.goal_mode >= checker.robot().modes.size())
    return invalid("the goal's mode is not one of the robot's");
  if (!(request.max_detour >= 1.0))
    return invalid("the largest detour must be 1 or more times the fastest plan's time");
  if (auto refused = refusalOf(checker, "start", request.start_mode, request.start,
                               ErrorCode::kStartOutOfBounds, ErrorCode::kStartInCollision))
    return refused;
  return refusalOfGoal(checker, request);
}

}  // namespace underway
