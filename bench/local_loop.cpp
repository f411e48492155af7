#include "bench/local_loop.hpp"

#include <cmath>
#include <numbers>

namespace underway::bench {
namespace {

constexpr double kLimit_s = 1800.0;  // simulated
constexpr double kArrival_m = 0.05;
constexpr double kArrival_rad = 5.0 * std::numbers::pi / 180.0;

Planner::Clock::time_point patience() { return Planner::Clock::now() + std::chrono::seconds(1); }

/// Whether there is no way in the true world either, from where the robot truly stands.
bool isTrulyBlocked(const Course& course, const std::shared_ptr<const Robot>& robot,
                    const sim::Truth& truth) {
  Planner planner(course.truth, robot);
  Request request = course.request;
  request.start = truth.pose;
  request.start_mode = truth.mode;
  return !planner.plan(request, Planner::Clock::now() + std::chrono::seconds(2));
}

void judge(const Course& course, const sim::Truth& truth, LoopRun& run) {
  run.has_collided = truth.has_collided;
  run.is_disputed = truth.is_disputed;
  if (truth.has_collided) run.why = "touched " + truth.with;
  run.off_m = distance(truth.pose.position(), course.request.goal);
  run.off_rad =
      course.request.goal_yaw ? std::abs(normalizedAngle(truth.pose.yaw - *course.request.goal_yaw)) : 0.0;
  run.has_arrived = run.outcome == Mission::Outcome::kArrived && run.off_m <= kArrival_m &&
                    run.off_rad <= kArrival_rad && truth.mode == course.request.goal_mode;
}

}  // namespace

LoopRun driveCourse(const Course& course, std::unique_ptr<Planner>& planner,
                    const std::shared_ptr<const Robot>& robot, const ExecutorSettings& settings,
                    const sim::Flaws& flaws, std::uint64_t seed, const WatchLoop& watch) {
  const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
    if (planner->checker()->world().hash() != world->hash()) planner->update(world);
    auto plan = planner->findPlan(request, patience());
    if (plan || plan.error().code != ErrorCode::kTimeout) return plan;
    planner = std::make_unique<Planner>(world, robot);
    return planner->plan(request, patience());
  };
  Mission mission(course.map, robot, course.request, source, settings);
  sim::SimulatedRobot body(course.truth, robot, course.request.start, course.request.start_mode, seed, flaws);
  LoopRun run;
  while (run.outcome == Mission::Outcome::kUnderway && !body.truth().has_collided &&
         body.now_s() < kLimit_s) {
    const Tick tick = mission.tick(body.sense());
    body.step(tick.command);
    run.outcome = mission.outcome();
    if (watch) watch(body, mission, tick);
  }
  run.why = mission.why();
  run.time_s = body.now_s();
  run.plans = mission.plans();
  judge(course, body.truth(), run);
  if (run.outcome == Mission::Outcome::kNoWay)
    run.is_truly_blocked = isTrulyBlocked(course, robot, body.truth());
  return run;
}

}  // namespace underway::bench
