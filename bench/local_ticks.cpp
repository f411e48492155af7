#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>

#include "bench/local_courses.hpp"
#include "bench/local_parts.hpp"
#include "bench/local_run.hpp"
#include "bench/stopwatch.hpp"
#include "local/executor.hpp"

namespace underway::bench {
namespace {

constexpr int kRuns = 5;
constexpr double kLimit_s = 1000.0;  // simulated

/// How long each tick of some runs takes. Every run is driven several times, each time the same, and what a
/// tick takes is its least: the rest is what else the machine does.
class TickTimes {
 public:
  /// From here on, the run before is repeated.
  void beginAgain() { next_ = begin_; }
  void beginAnother() { begin_ = next_ = least_us_.size(); }

  template <class Work>
  auto time(const Work& tick) {
    const double begun_s = processorTime();
    const auto begun = std::chrono::steady_clock::now();
    auto result = tick();
    const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - begun;
    const double took_us = 1e6 * (processorTime() - begun_s);
    wall_us_.push_back(passed.count());
    if (next_ == least_us_.size()) least_us_.push_back(took_us), kinds_.emplace_back();
    least_us_[next_] = std::min(least_us_[next_], took_us);
    return result;
  }
  /// What the tick was that was timed last.
  void was(std::string_view kind) { kinds_[next_++] = kind; }

  void report(const std::string& what, Report& report) const {
    add(what + ", processor time, p50", quantile(least_us_, 0.5), least_us_.size(), report);
    add(what + ", processor time, p99", quantile(least_us_, 0.99), least_us_.size(), report);
    report.rows.push_back({what + ", by the clock, with all else that runs, p99",
                           quantile(wall_us_, 0.99),
                           "us",
                           "",
                           {},
                           1,
                           wall_us_.size(),
                           {},
                           {}});
  }
  void report(const std::string& what, std::string_view kind, Report& report) const {
    std::vector<double> took_us;
    for (std::size_t i = 0; i < kinds_.size(); ++i)
      if (kinds_[i] == kind) took_us.push_back(least_us_[i]);
    if (took_us.empty()) return;
    add(what + " while " + std::string(kind) + ", processor time, p99", quantile(took_us, 0.99),
        took_us.size(), report);
  }

 private:
  static void add(const std::string& what, double took_us, std::size_t ticks, Report& report) {
    constexpr double kMost_us = 20.0;
    report.rows.push_back({what, took_us, "us", "<= 20", took_us <= kMost_us, 1, ticks, {}, {}});
  }

  std::size_t begin_ = 0;  // of the run that is repeated
  std::size_t next_ = 0;
  std::vector<double> least_us_;
  std::vector<double> wall_us_;  // of every repetition
  std::vector<std::string_view> kinds_;
};

/// GODZILA through a random gap.
void driveGap(const LocalBench& bench, std::uint64_t seed, TickTimes& times) {
  const PureRoom room = randomGap(seed);
  sim::SimulatedRobot body(room.world, bench.robot, room.start, 0, seed);
  PureSettings settings;
  settings.keeps_traps = true;
  Godzila godzila(settings, bench.robot->modes.front().body_m, standingLimits(*bench.robot), Beams{});
  for (auto state = Godzila::State::kSeeking; state != Godzila::State::kArrived && body.now_s() < kLimit_s;) {
    const Senses& senses = body.sense();
    const Bearing goal = bearingOf(room.goal, senses.pose->pose);
    const auto drive = times.time([&] { return godzila.tick(*senses.scan, goal); });
    times.was("seeking");
    state = drive.state;
    body.step({drive.velocity, std::nullopt});
  }
}

/// A plan's execution by the executor.
void drivePlan(const LocalBench& bench, const Course& course, const Plan& plan, TickTimes& times) {
  sim::SimulatedRobot body(course.truth, bench.robot, course.request.start, course.request.start_mode, 1);
  Executor executor(bench.robot);
  executor.follow(plan, course.map, *course.map);
  while (executor.state() != State::kArrived && body.now_s() < kLimit_s) {
    const Senses& senses = body.sense();
    const Tick tick = times.time([&] { return executor.tick(senses); });
    times.was(name(tick.state));
    body.step(tick.command);
  }
}

/// Walking, aligning and crawling in scenario 3 and in the flat.
Expected<TickTimes> executorTimes(const LocalBench& bench) {
  TickTimes times;
  for (const std::string map : {"scenario3", "flat"}) {
    const auto courses = coursesOf(bench.options.data / "maps" / (map + ".yaml"), *bench.robot);
    if (!courses) return tl::unexpected(courses.error());
    Planner planner(courses->front().map, bench.robot);
    planner.prepare(Planner::Clock::now() + std::chrono::seconds(20));
    for (const Course& course : *courses) {
      const auto plan = planner.findPlan(course.request, Planner::Clock::now() + std::chrono::seconds(5));
      if (!plan) return tl::unexpected(plan.error());
      times.beginAnother();
      for (int run = 0; run < kRuns; ++run) times.beginAgain(), drivePlan(bench, course, *plan, times);
    }
  }
  return times;
}

}  // namespace

Expected<void> addTicks(const LocalBench& bench, Report& report) {
  TickTimes alone;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    alone.beginAnother();
    for (int run = 0; run < kRuns; ++run) alone.beginAgain(), driveGap(bench, seed, alone);
  }
  alone.report("one tick of GODZILA, 683 beams", report);
  const auto executor = executorTimes(bench);
  if (!executor) return tl::unexpected(executor.error());
  executor->report("one tick of the executor, 683 beams", report);
  for (const State state : {State::kWalking, State::kAligning, State::kCrawling})
    executor->report("the executor", name(state), report);
  return {};
}

}  // namespace underway::bench
