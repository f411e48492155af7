#include "planner/replan.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/stale.hpp"

namespace underway {
namespace {

/// The part of a motion after a share of it.
Motion after(const Motion& motion, double done) {
  switch (motion.kind) {
    case MotionKind::kTranslate: {
      const Pose from{std::lerp(motion.from.x, motion.to.x, done),
                      std::lerp(motion.from.y, motion.to.y, done), motion.from.yaw};
      return translate(motion.mode, motion.sense, from, motion.to.position());
    }
    case MotionKind::kTurn: {
      Pose from = motion.from;
      from.yaw = normalizedAngle(from.yaw + done * motion.angle_rad);
      return turn(motion.mode, from, (1.0 - done) * motion.angle_rad, motion.to.yaw);
    }
    case MotionKind::kSwitch:
      break;
  }
  return motion;
}

double metresIn(const Plan& plan, ModeId mode) {
  double sum = 0.0;
  for (const Segment& segment : plan.segments)
    if (segment.motion.mode == mode) sum += length(segment.motion);
  return sum;
}

/// Whether one plan is better than another by what counts for the policy: more than 0 yes, less than 0 worse,
/// 0 not by what comes before time.
int comparedBeforeTime(const Plan& fresh, const Plan& old, const Request& request, const Robot& robot,
                       const Reluctance& reluctance) {
  if (request.policy == Policy::kSafest) {
    const double more_m = leastClearance(fresh) - leastClearance(old);
    return std::abs(more_m) <= reluctance.clearance_m ? 0 : more_m > 0.0 ? 1 : -1;
  }
  if (request.policy != Policy::kPriority) return 0;
  for (auto mode = static_cast<ModeId>(robot.modes.size() - 1); mode > 0; --mode) {
    const double less_m = metresIn(old, mode) - metresIn(fresh, mode);
    if (std::abs(less_m) > reluctance.distance_m) return less_m > 0.0 ? 1 : -1;
  }
  return 0;
}

bool isWorthIt(const Plan& fresh, const Plan& old, const Request& request, const Robot& robot,
               const Reluctance& reluctance) {
  const int compared = comparedBeforeTime(fresh, old, request, robot, reluctance);
  if (compared != 0) return compared > 0;
  const double saved_s = old.total_time_s - fresh.total_time_s;
  return saved_s > std::max(reluctance.least_s, reluctance.share * old.total_time_s);
}

}  // namespace

Plan rest(const Executing& executing, const Robot& robot) {
  std::vector<Segment> segments(
      executing.plan.segments.begin() + static_cast<std::ptrdiff_t>(executing.segment),
      executing.plan.segments.end());
  if (!segments.empty()) {
    Segment& first = segments.front();
    first.motion = after(first.motion, std::clamp(executing.done, 0.0, 1.0));
    first.duration_s = duration(robot, first.motion);
  }
  const Pose start = segments.empty() ? executing.plan.goal : segments.front().motion.from;
  Plan plan = timedPlan(std::move(segments), start);
  plan.revision = executing.plan.revision;
  plan.stats = executing.plan.stats;
  return plan;
}

Expected<Replanned> replan(Planner& planner, const Executing& executing, const Request& request,
                           Planner::Clock::time_point deadline, const Reluctance& reluctance,
                           const std::stop_token& stop) {
  if (executing.segment > executing.plan.segments.size())
    return fail(ErrorCode::kInvalidRequest,
                fmt::format("the plan has {} segments; segment {} is not one of them",
                            executing.plan.segments.size(), executing.segment + 1));
  const auto checker = planner.checker();
  const Robot& robot = checker->robot();
  Plan left = rest(executing, robot);
  const auto broken = firstBroken(executing.plan, *checker, executing.segment);
  auto fresh = planner.plan(request, deadline, stop);
  if (broken) {
    if (!fresh) return tl::unexpected(fresh.error());
    return Replanned{std::move(*fresh), true,
                     fmt::format("segment {} of the plan is blocked now", *broken + 1)};
  }
  if (!fresh) return Replanned{std::move(left), false, "the plan still holds; no other was found"};
  if (isWorthIt(*fresh, left, request, robot, reluctance))
    return Replanned{std::move(*fresh), true,
                     fmt::format("the new plan takes {:.1f} s, what is left of the old one {:.1f} s",
                                 fresh->total_time_s, left.total_time_s)};
  return Replanned{
      std::move(left), false,
      fmt::format("the plan still holds, and a new one would save {:.1f} s of {:.1f} s: not enough",
                  left.total_time_s - fresh->total_time_s, left.total_time_s)};
}

}  // namespace underway
