#include "bench/local_loop.hpp"

#include <cmath>
#include <numbers>

namespace underway::bench {
namespace {

constexpr double kLimit_s = 1800.0;  // simulated
constexpr double kArrival_m = 0.05;
constexpr double kArrival_rad = 5.0 * std::numbers::pi / 180.0;

Planner::Clock::time_point in(int seconds) { return Planner::Clock::now() + std::chrono::seconds(seconds); }

/// Whether a robot stands where it is proven, not only not found, that no plan leads to the goal.
bool isBlocked(const std::shared_ptr<const World>& world, const std::shared_ptr<const Robot>& robot,
               Request request, const sim::Truth& from) {
  request.start = from.pose;
  request.start_mode = from.mode;
  const auto plan = Planner(world, robot).plan(request, in(10));
  return !plan && plan.error().code == ErrorCode::kNoPathExists;
}

/// The true world with all that is not in the map larger to all sides: what noisy senses cannot tell from
/// free.
std::shared_ptr<const World> withSoundMargins(const Course& course) {
  constexpr double kMargin_m = 0.02;  // twice the lidar's sigma
  World world = *course.truth;
  for (const Obstacle& obstacle : course.truth->obstacles()) {
    if (!obstacle.id.starts_with(kUnmapped)) continue;
    OrientedBox box = obstacle.box;
    box.size_m.x += 2.0 * kMargin_m;
    box.size_m.y += 2.0 * kMargin_m;
    world = *world.moved(obstacle.id, box);
  }
  return std::make_shared<const World>(std::move(world));
}

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

LoopRun driveCourse(const Course& course, std::unique_ptr<Planner>& planner,
                    const std::shared_ptr<const Robot>& robot, const ExecutorSettings& settings,
                    const sim::Flaws& flaws, std::uint64_t seed, const WatchLoop& watch) {
  const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
    if (planner->checker()->world().hash() != world->hash()) planner->update(world);
    auto plan = planner->findPlan(request, in(1));
    if (plan || plan.error().code != ErrorCode::kTimeout) return plan;
    planner = std::make_unique<Planner>(world, robot);
    return planner->plan(request, in(5));
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
    run.is_truly_blocked = isBlocked(course.truth, robot, course.request, body.truth());
    run.is_soundly_blocked =
        run.is_truly_blocked || isBlocked(withSoundMargins(course), robot, course.request, body.truth());
  }
  return run;
}

}  // namespace underway::bench
