#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "bench/local_courses.hpp"
#include "bench/local_parts.hpp"
#include "server/change_service.hpp"
#include "server/plan_service.hpp"
#include "server/robot/remote_plans.hpp"

namespace underway::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array kMaps{"scenario1", "scenario2a", "scenario3", "arena_open", "arena_corridor", "flat"};
constexpr double kLimit_s = 900.0;  // simulated
constexpr const char* kName = "bench";

/// A real server of a map.
struct Serving {
  std::shared_ptr<Planner> planner;
  PlanService plans;
  ChangeService changes;
};

Expected<Serving> serve(const std::shared_ptr<const Domain>& domain, const Course& course,
                        const std::shared_ptr<const Robot>& robot) {
  auto planner = std::make_shared<Planner>(course.map, robot);
  planner->prepare(Planner::Clock::now() + std::chrono::seconds(20));
  auto plans =
      PlanService::start(domain, {*robot, course.map->name(), hashOf(*robot), 1}, handlerFor(planner));
  if (!plans) return tl::unexpected(plans.error());
  auto changes = ChangeService::start(domain, planner);
  if (!changes) return tl::unexpected(changes.error());
  return Serving{std::move(planner), std::move(*plans), std::move(*changes)};
}

/// What was measured.
struct Times {
  std::vector<double> ms;     // from the tick that says blocked to the first command of the new plan
  std::vector<double> ticks;  // from that tick to the one of that command
  unsigned long refused = 0;  // there was no plan round what was seen
};

bool moves(const Command& command) { return !(command.velocity == Velocity{}) || command.change_to; }

/// Drives a course and measures what its ticks take from each 'blocked' on that a plan answers.
void drive(const Course& course, const std::shared_ptr<const Robot>& robot, RemotePlans& plans,
           std::uint64_t seed, Times& times) {
  const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
    return plans.plan(request, *world);
  };
  Mission mission(course.map, robot, course.request, source);
  sim::SimulatedRobot body(course.truth, robot, course.request.start, course.request.start_mode, seed);
  double ms = 0.0;
  int ticks = -1;  // since it was blocked; -1: it is not
  while (mission.outcome() == Mission::Outcome::kUnderway && body.now_s() < kLimit_s) {
    const Senses& senses = body.sense();
    const int known = mission.plans();
    const auto began = Clock::now();
    const Tick tick = mission.tick(senses);
    const double took_ms = std::chrono::duration<double, std::milli>(Clock::now() - began).count();
    body.step(tick.command);
    if (tick.state == State::kBlocked && mission.plans() == known) ++times.refused;
    if (tick.state == State::kBlocked && mission.plans() > known) {
      ms = took_ms;
      ticks = 0;
    } else if (ticks >= 0) {
      ms += took_ms;
      ++ticks;
    }
    if (ticks > 0 && moves(tick.command)) {
      times.ms.push_back(ms);
      times.ticks.push_back(ticks);
      ticks = -1;
    }
  }
  plans.forget();
}

Expected<void> driveMap(const LocalBench& bench, const std::string& map, unsigned long seeds, Times& times) {
  const auto courses = coursesOf(bench.options.data / "maps" / (map + ".yaml"), *bench.robot);
  if (!courses) return tl::unexpected(courses.error());
  const auto domain = Domain::open({.tag = "underway-bench-" + std::to_string(getpid())});
  if (!domain) return tl::unexpected(domain.error());
  const auto served = serve(*domain, courses->front(), bench.robot);
  if (!served) return tl::unexpected(served.error());
  auto plans = RemotePlans::open(*domain, kName, courses->front().map, bench.robot);
  if (!plans) return tl::unexpected(plans.error());
  for (unsigned long seed = 1; seed <= seeds; ++seed) {
    const Course& course = (*courses)[seed % courses->size()];
    const auto plan = served->planner->findPlan(course.request, Clock::now() + std::chrono::seconds(5));
    if (!plan) continue;
    drive(withUnmappedBoxes(course, *plan, bench.robot, seed), bench.robot, *plans, seed, times);
  }
  return {};
}

}  // namespace

Expected<void> addBlocked(const LocalBench& bench, Report& report) {
  const unsigned long seeds = bench.seeds(40);
  Times times;
  for (std::size_t i = 0; i < kMaps.size(); ++i) {
    if (const auto driven = driveMap(bench, kMaps.at(i), seeds, times); !driven) return driven;
    bench.progress(static_cast<double>(i + 1) / kMaps.size());
  }
  if (times.ms.empty())
    return fail(ErrorCode::kInternal, "no robot was ever blocked: there is nothing to measure");
  const std::string what = "blocked to new command, with the server: ";
  const auto add = [&](const std::string& name, double value, const char* unit, const char* goal,
                       bool is_met) {
    report.rows.push_back({what + name,
                           value,
                           unit,
                           goal,
                           goal[0] == '\0' ? std::optional<bool>() : is_met,
                           1,
                           times.ms.size(),
                           {},
                           {}});
  };
  const double p99 = quantile(times.ms, 0.99);
  add("p50", quantile(times.ms, 0.5), "ms", "", false);
  add("p99", p99, "ms", "< 100", p99 < 100.0);
  const auto quick = std::count_if(times.ms.begin(), times.ms.end(), [](double ms) { return ms < 100.0; });
  add("within 100 ms", 100.0 * static_cast<double>(quick) / static_cast<double>(times.ms.size()), "%", "",
      false);
  add("most", quantile(times.ms, 1.0), "ms", "", false);
  add("ticks between, most", quantile(times.ticks, 1.0), "ticks", "", false);
  add("refused by the server", static_cast<double>(times.refused), "times", "", false);
  return {};
}

}  // namespace underway::bench
