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
constexpr double kAsked_ms = 100.0;
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
  unsigned batches = 0;       // of the roadmap in the end
};

bool moves(const Command& command) { return !(command.velocity == Velocity{}) || command.change_to; }

/// Drives a course and measures what its ticks take from each 'blocked' on that a plan answers.
void drive(const Course& course, const std::shared_ptr<const Robot>& robot, RemotePlans& plans,
           std::uint64_t seed, Times& times) {
  const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
    auto plan = plans.plan(request, *world);
    if (!plan) ++times.refused;
    return plan;
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

Expected<void> driveMap(const LocalBench& bench, const std::filesystem::path& map, Times& times) {
  const auto courses = coursesOf(map, *bench.robot);
  if (!courses) return tl::unexpected(courses.error());
  const auto domain = Domain::open({.tag = "underway-bench-" + std::to_string(getpid())});
  if (!domain) return tl::unexpected(domain.error());
  const auto served = serve(*domain, courses->front(), bench.robot);
  if (!served) return tl::unexpected(served.error());
  auto plans = RemotePlans::open(*domain, kName, courses->front().map, bench.robot);
  if (!plans) return tl::unexpected(plans.error());
  for (const unsigned long seed : bench.seeds(40)) {
    const Course& course = (*courses)[seed % courses->size()];
    const auto plan = served->planner->findPlan(course.request, Clock::now() + std::chrono::seconds(5));
    if (!plan) continue;
    drive(withUnmappedBoxes(course, *plan, bench.robot, seed), bench.robot, *plans, seed, times);
  }
  if (const auto roadmap = served->planner->roadmap()) times.batches = roadmap->batches;
  return {};
}

void addRow(const std::string& name, double value, const char* unit, const Times& of, Report& report) {
  report.rows.push_back(
      {"blocked to new command, with the server" + name, value, unit, "", {}, 1, of.ms.size(), {}, {}});
}

/// How quick it was in a map, and what the roadmap has grown to by then: the more, the longer queries take.
void addMap(const std::string& map, const Times& times, Report& report) {
  if (times.ms.empty()) return;
  addRow(", " + map + ": p50", quantile(times.ms, 0.5), "ms", times, report);
  addRow(", " + map + ": p99", quantile(times.ms, 0.99), "ms", times, report);
  addRow(", " + map + ": the roadmap in the end", times.batches, "batches", times, report);
}

void addAll(const Times& times, Report& report) {
  const auto quick =
      std::count_if(times.ms.begin(), times.ms.end(), [](double ms) { return ms < kAsked_ms; });
  addRow(": p50", quantile(times.ms, 0.5), "ms", times, report);
  addRow(": p99", quantile(times.ms, 0.99), "ms", times, report);
  report.rows.back().goal = "< 100";
  report.rows.back().met = quantile(times.ms, 0.99) < kAsked_ms;
  addRow(": most", quantile(times.ms, 1.0), "ms", times, report);
  addRow(": within 100 ms", 100.0 * static_cast<double>(quick) / static_cast<double>(times.ms.size()), "%",
         times, report);
  addRow(": ticks to the command, most", quantile(times.ticks, 1.0), "ticks", times, report);
  addRow(": 'no' for an answer", static_cast<double>(times.refused), "times", times, report);
}

}  // namespace

Expected<void> addBlocked(const LocalBench& bench, Report& report) {
  const auto maps = bench.maps(kMaps);
  Times all;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    Times times;
    if (const auto driven = driveMap(bench, maps[i], times); !driven) return driven;
    addMap(maps[i].stem().string(), times, report);
    all.ms.insert(all.ms.end(), times.ms.begin(), times.ms.end());
    all.ticks.insert(all.ticks.end(), times.ticks.begin(), times.ticks.end());
    all.refused += times.refused;
    bench.progress(static_cast<double>(i + 1) / static_cast<double>(maps.size()));
  }
  if (all.ms.empty())
    return fail(ErrorCode::kInternal, "no robot was ever blocked: there is nothing to measure");
  addAll(all, report);
  return {};
}

}  // namespace underway::bench
