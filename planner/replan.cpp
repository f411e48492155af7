#include "planner/replan.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/certify.hpp"
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

/// A switch that has begun cannot be broken off.
bool isInSwitch(const Executing& executing) {
  return executing.segment < executing.plan.segments.size() && executing.done > 0.0 &&
         executing.plan.segments[executing.segment].motion.kind == MotionKind::kSwitch;
}

Plan afterFirst(const Plan& plan) {
  return timedPlan({plan.segments.begin() + 1, plan.segments.end()}, plan.segments.front().motion.to);
}

/// What is wrong with it for any world; empty if nothing is.
std::string faultOf(const Executing& executing, const Robot& robot) {
  const std::vector<Segment>& segments = executing.plan.segments;
  if (executing.segment > segments.size())
    return fmt::format("the plan has {} segments; segment {} is not one of them", segments.size(),
                       executing.segment + 1);
  if (!(executing.done >= 0.0 && executing.done <= 1.0))
    return fmt::format("{} is no share of a segment; give 0 to 1", executing.done);
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (!std::isfinite(duration(robot, segments[i].motion)))
      return fmt::format("robot {} cannot do segment {} of the plan: it has no such sense, turn or switch",
                         robot.name, i + 1);
  return {};
}

/// That a segment, counted in the whole plan, is not free any more.
Error blocked(const Motion& motion, std::size_t segment, const Checker& checker) {
  Error error{ErrorCode::kStaleRevision,
              fmt::format("segment {} of the plan is blocked now", segment + 1),
              {},
              checker.world().revision(),
              checker.world().hash()};
  const std::string& mode = checker.robot().modes[motion.mode].name;
  for (const std::string& id : checker.blockers(motion, checker.robot().margin_m)) {
    error.message += (error.blocking.empty() ? " by " : ", ") + id;
    error.blocking.push_back({id, mode, "", 0.0, 0.0});
  }
  return error;
}

/// What a plan might have been asked for.
Request requestOf(const Plan& plan) {
  Request request;
  request.start = plan.goal;
  request.goal = plan.goal.position();
  request.goal_yaw = plan.goal.yaw;
  if (plan.segments.empty()) return request;
  request.start = plan.segments.front().motion.from;
  request.start_mode = plan.segments.front().motion.mode;
  request.goal_mode = plan.segments.back().motion.to_mode;
  return request;
}

/// The goal of a request that a plan leads to, by its number.
std::optional<std::uint32_t> goalOf(const Plan& plan, const Request& request) {
  constexpr double kGoal_m = 0.01;  // formats: 'Plan'
  constexpr double kGoal_rad = 0.02;
  const ModeId mode = plan.segments.empty() ? request.start_mode : plan.segments.back().motion.to_mode;
  const std::vector<Goal> goals = goalsOf(request);
  for (std::uint32_t i = 0; i < goals.size(); ++i)
    if (goals[i].mode == mode && distance(goals[i].at, plan.goal.position()) <= kGoal_m &&
        (!goals[i].yaw || std::abs(normalizedAngle(*goals[i].yaw - plan.goal.yaw)) <= kGoal_rad))
      return i;
  return std::nullopt;
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
  plan.world_hash = executing.plan.world_hash;
  plan.stats = executing.plan.stats;
  return plan;
}

Onward onward(const Executing& executing, const Robot& robot) {
  const Plan left = rest(executing, robot);
  if (left.segments.empty()) {
    const std::vector<Segment>& all = executing.plan.segments;
    return {left.goal, all.empty() ? ModeId{0} : all.back().motion.to_mode};
  }
  const Motion& first = left.segments.front().motion;
  return isInSwitch(executing) ? Onward{first.to, first.to_mode} : Onward{first.from, first.mode};
}

Expected<Plan> remaining(const Executing& executing, const Checker& checker) {
  if (std::string fault = faultOf(executing, checker.robot()); !fault.empty())
    return fail(ErrorCode::kInvalidRequest, std::move(fault));
  Plan left = rest(executing, checker.robot());
  if (const auto broken = firstBroken(left, checker))
    return tl::unexpected(blocked(left.segments[*broken].motion, executing.segment + *broken, checker));
  for (Segment& segment : left.segments)
    segment.closeness = checker.closeness(segment.motion, kClearanceCap_m);
  left.revision = checker.world().revision();
  left.world_hash = checker.world().hash();
  if (const auto flaws = certify(left, requestOf(left), checker); !flaws.empty())
    return fail(
        ErrorCode::kInvalidRequest,
        fmt::format("what is being followed is no plan of robot {}: segment {} {}", checker.robot().name,
                    executing.segment + flaws.front().segment + 1, flaws.front().sentence));
  return left;
}

Expected<Replanned> replan(Planner& planner, const Executing& executing, const Request& request,
                           Planner::Clock::time_point deadline, const Reluctance& reluctance,
                           const std::stop_token& stop) {
  const auto checker = planner.checker();
  const Robot& robot = checker->robot();
  Expected<Plan> left = remaining(executing, *checker);
  if (!left && left.error().code == ErrorCode::kInvalidRequest) return tl::unexpected(left.error());
  auto fresh = planner.plan(request, deadline, stop);
  if (const auto now = planner.checker(); now != checker) left = remaining(executing, *now);
  const auto leads_to = left ? goalOf(*left, request) : std::nullopt;
  if (!leads_to) {
    if (!fresh) return tl::unexpected(fresh.error());
    return Replanned{std::move(*fresh), true,
                     left ? "the plan that was followed leads to none of the goals" : left.error().message};
  }
  left->goal_index = *leads_to;
  if (!fresh) return Replanned{std::move(*left), false, "the plan still holds; no other was found"};
  const Plan old = isInSwitch(executing) ? afterFirst(*left) : *left;  // which is where the new one begins
  if (isWorthIt(*fresh, old, request, robot, reluctance))
    return Replanned{std::move(*fresh), true,
                     fmt::format("the new plan takes {:.1f} s, what is left of the old one {:.1f} s",
                                 fresh->total_time_s, old.total_time_s)};
  const double saved_s = old.total_time_s - fresh->total_time_s;
  return Replanned{
      std::move(*left), false,
      fmt::format("the plan still holds, and a new one would save {:.1f} s of {:.1f} s: not enough",
                  std::max(saved_s, 0.0), old.total_time_s)};
}

}  // namespace underway
