#include "bench/local_loop.hpp"

#include <cmath>
#include <numbers>

namespace underway::bench {
namespace {

constexpr double kLimit_s = 1800.0;  // simulated
constexpr double kArrival_m = 0.05;
constexpr double kArrival_rad = 5.0 * std::numbers::pi / 180.0;

double headingOff(const Request& request, const Pose& pose) {
  return request.goal_yaw ? std::abs(normalizedAngle(pose.yaw - *request.goal_yaw)) : 0.0;
}

void judge(const Course& course, const sim::Truth& truth, LoopRun& run) {
  run.has_collided = truth.has_collided;
  run.is_disputed = truth.is_disputed;
  if (truth.has_collided) run.why = "touched " + truth.with;
  run.off_m = distance(truth.pose.position(), course.request.goal);
  run.off_rad = headingOff(course.request, truth.pose);
  run.has_arrived =
      run.outcome == Mission::Outcome::kArrived && isAtGoal(course.request, truth.pose, truth.mode);
}

}  // namespace

bool isAtGoal(const Request& request, const Pose& pose, ModeId mode) {
  return mode == request.goal_mode && distance(pose.position(), request.goal) <= kArrival_m &&
         headingOff(request, pose) <= kArrival_rad;
}

LoopRun driveCourse(const Course& course, Planner& planner, const std::shared_ptr<const Robot>& robot,
                    const ExecutorSettings& settings, const sim::Flaws& flaws, std::uint64_t seed,
                    const WatchLoop& watch, std::chrono::seconds planning) {
  const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
    if (planner.checker()->world().hash() != world->hash()) planner.update(world);
    return planner.plan(request, Planner::Clock::now() + planning);
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
  if (run.outcome == Mission::Outcome::kNoWay) {
    Request from_here = course.request;
    from_here.start = body.truth().pose;
    from_here.start_mode = body.truth().mode;
    run.no_way = noWay(course.truth, robot, from_here);
  }
  return run;
}

}  // namespace underway::bench
