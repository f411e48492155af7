#include <algorithm>
#include <cmath>

#include "bench/local_courses.hpp"
#include "bench/local_parts.hpp"
#include "bench/local_run.hpp"
#include "bench/minimiser.hpp"
#include "bench/stopwatch.hpp"
#include "geometry/map.hpp"
#include "local/executor.hpp"

namespace underway::bench {
namespace {

void addMinimiser(const LocalBench& bench, Report& report) {
  const unsigned long cases = bench.seeds(100'000);
  double worst = 0.0;
  for (unsigned long seed = 1; seed <= cases; ++seed) {
    const HeadingCase any = randomHeadingCase(seed);
    const HeadingOptimum optimum(any.settings, any.scan.beams);
    const double closed = optimum.of(any.scan, any.goal, any.facing_rad).heading_rad;
    const double searched = leastCostHeading(any.scan, any.goal, any.facing_rad, any.settings);
    worst = std::max(worst, std::abs(normalizedAngle(closed - searched)));
    if (seed % 64 == 0) bench.progress(static_cast<double>(seed) / static_cast<double>(cases));
  }
  report.rows.push_back({"heading against a numerical minimiser of (3.6), furthest",
                         worst,
                         "rad",
                         "<= 1e-6",
                         worst <= 1e-6,
                         1,
                         cases,
                         {},
                         {}});
}

/// The slowest hundredth of some ticks, each timed by itself.
void addTicks(const char* what, const std::vector<double>& took_us, Report& report) {
  const double p99 = quantile(took_us, 0.99);
  report.rows.push_back({std::string(what) + ", 683 beams, processor time, p99",
                         p99,
                         "us",
                         "<= 20",
                         p99 <= 20.0,
                         1,
                         took_us.size(),
                         {},
                         {}});
}

/// GODZILA through random gaps.
void addGodzilaTick(const LocalBench& bench, Report& report) {
  std::vector<double> took_us;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PureRoom room = randomGap(seed);
    sim::SimulatedRobot body(room.world, bench.robot, room.start, 0, seed);
    PureSettings settings;
    settings.keeps_traps = true;
    Godzila godzila(settings, bench.robot->modes.front().body_m, standingLimits(*bench.robot), Beams{});
    for (int k = 0; k < 4000; ++k) {
      const Senses& senses = body.sense();
      const Bearing goal = bearingOf(room.goal, senses.pose->pose);
      const double begun = processorTime();
      const auto drive = godzila.tick(*senses.scan, goal);
      took_us.push_back(1e6 * (processorTime() - begun));
      if (drive.state == Godzila::State::kArrived) break;
      body.step({drive.velocity, std::nullopt});
    }
  }
  addTicks("one tick of GODZILA", took_us, report);
}

/// Each tick of a plan's execution, by the executor: scenario 3, walking and crawling.
Expected<void> addExecutorTick(const LocalBench& bench, Report& report) {
  const auto courses = coursesOf(bench.options.data / "maps" / "scenario3.yaml", *bench.robot);
  if (!courses) return tl::unexpected(courses.error());
  const Course& course = courses->front();
  Planner planner(course.map, bench.robot);
  auto plan = planner.findPlan(course.request, Planner::Clock::now() + std::chrono::seconds(10));
  if (!plan) return tl::unexpected(plan.error());
  sim::SimulatedRobot body(course.truth, bench.robot, course.request.start, 0, 1);
  Executor executor(bench.robot);
  executor.follow(std::move(*plan), course.map, *course.map);
  std::vector<double> took_us;
  while (executor.state() != State::kArrived && body.now_s() < 1000.0) {
    const Senses& senses = body.sense();
    const double begun = processorTime();
    const Tick tick = executor.tick(senses);
    took_us.push_back(1e6 * (processorTime() - begun));
    body.step(tick.command);
  }
  addTicks("one tick of the executor", took_us, report);
  return {};
}

}  // namespace

Expected<void> addHeading(const LocalBench& bench, Report& report) {
  addMinimiser(bench, report);
  addGodzilaTick(bench, report);
  return addExecutorTick(bench, report);
}

}  // namespace underway::bench
