#include <pthread.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <ctime>
#include <random>
#include <thread>

#include "bench/planner_parts.hpp"
#include "bench/requests.hpp"
#include "bench/stopwatch.hpp"
#include "planner/concurrent_proof.hpp"

namespace underway::bench {
namespace {

using Clock = Planner::Clock;
using Seconds = std::chrono::duration<double>;

constexpr std::array kMaps{"scenario3", "office", "flat", "too_low", "too_narrow"};
constexpr double kShortest_s = 0.0002;  // deadline
constexpr double kLongest_s = 0.03;
constexpr double kPunctual_s = 0.0002;  // later than that, the watch has missed the deadline
constexpr std::size_t kFreshEvery = 4;  // a new planner, which has a roadmap to grow

/// A thread that reads another's processor time at a deadline.
class Watch {
 public:
  Watch(clockid_t clock, Clock::time_point deadline)
      : thread_([this, clock, deadline] {
          std::this_thread::sleep_until(deadline);
          late_s_ = Seconds(Clock::now() - deadline).count();
          at_deadline_s_ = processorTime(clock);
        }) {}

  /// Processor time since the deadline, once the work is done; nothing if the watch itself was late.
  std::optional<double> spentSince(double processor_s) {
    thread_.join();
    if (late_s_ > kPunctual_s) return std::nullopt;
    return std::max(0.0, processor_s - at_deadline_s_) + late_s_;
  }

 private:
  double late_s_ = 0.0;
  double at_deadline_s_ = 0.0;
  std::thread thread_;  // last: it writes to the others
};

struct Site {
  std::shared_ptr<const World> world;
  std::shared_ptr<const Robot> robot;
  std::vector<Request> requests;
};

Expected<Site> siteOf(const PlannerOptions& options, const char* name) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  auto map = readMap(options.data / "maps" / (std::string(name) + ".yaml"));
  if (!map) return tl::unexpected(map.error());
  Site site{nullptr, *robot, {}};
  for (const Query& query : map->queries)
    if (query.expect != "start_in_collision" && query.expect != "goal_in_collision" &&
        query.expect != "start_out_of_bounds" && query.expect != "goal_out_of_bounds")
      site.requests.push_back(requestOf(query, **robot));
  site.world = std::make_shared<const World>(std::move(map->world));
  return site;
}

/// How long one waits for a proof's thread to give up, at any moment of its work.
Expected<void> addGivingUp(const PlannerOptions& options, std::mt19937_64& random, Report& report) {
  const int runs = options.quick ? 10 : 100;  // in each map
  std::uniform_int_distribution<int> moment_us(0, 200'000);
  std::vector<double> waited_ms;
  for (const char* map : kMaps) {
    const auto site = siteOf(options, map);
    if (!site) return tl::unexpected(site.error());
    const auto checker = std::make_shared<const Checker>(site->world, site->robot);
    for (int i = 0; i < runs; ++i) {
      ConcurrentProof proof(checker, site->requests.front(), {}, Clock::time_point::max(), {});
      std::this_thread::sleep_for(std::chrono::microseconds(moment_us(random)));
      if (proof.isOver()) continue;
      const auto ending = Clock::now();
      (void)proof.end();
      waited_ms.push_back(1e3 * Seconds(Clock::now() - ending).count());
    }
  }
  for (const double p : {0.5, 0.99})
    if (!waited_ms.empty())
      report.rows.push_back(
          {std::string("a proof under way gives up, by the clock, p") + (p < 0.9 ? "50" : "99"),
           quantile(waited_ms, p),
           "ms",
           "",
           {},
           1,
           waited_ms.size(),
           {},
           {}});
  return {};
}

}  // namespace

Expected<void> addDeadlines(const PlannerOptions& options, Report& report, const Progress& progress) {
  const std::size_t queries = options.quick ? 200 : 5000;
  constexpr std::array kPolicies{Policy::kPriority, Policy::kFastest, Policy::kSafest};
  clockid_t clock{};
  pthread_getcpuclockid(pthread_self(), &clock);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> allowed_s(kShortest_s, kLongest_s);
  std::vector<double> after_ms;
  std::size_t missed = 0;
  for (std::size_t m = 0; m < kMaps.size(); ++m) {
    const auto site = siteOf(options, kMaps.at(m));
    if (!site) return tl::unexpected(site.error());
    std::unique_ptr<Planner> planner;
    for (std::size_t i = 0; i < queries / kMaps.size(); ++i) {
      if (i % kFreshEvery == 0)
        planner = std::make_unique<Planner>(site->world, site->robot, GrowthSettings{i + 1, 3.0});
      Request request = site->requests[i % site->requests.size()];
      request.policy = kPolicies.at(i % kPolicies.size());
      const auto deadline =
          Clock::now() + std::chrono::duration_cast<Clock::duration>(Seconds(allowed_s(random)));
      Watch watch(clock, deadline);
      const auto plan = planner->plan(request, deadline);
      const double processor_s = processorTime(clock);
      const bool is_late = Clock::now() >= deadline;
      const auto spent_s = watch.spentSince(processor_s);
      if (is_late && spent_s)
        after_ms.push_back(1e3 * *spent_s);
      else
        is_late ? ++missed : 0;
      progress(
          (static_cast<double>(m) + static_cast<double>(i * kMaps.size()) / static_cast<double>(queries)) /
          kMaps.size());
    }
  }
  const auto add = [&](const char* what, double value, const char* unit, const char* goal,
                       std::optional<bool> met) {
    report.rows.push_back(
        {std::string("after the deadline: ") + what, value, unit, goal, met, 1, after_ms.size(), {}, {}});
  };
  add("calls not measured, the watch being late", static_cast<double>(missed), "", "", std::nullopt);
  if (after_ms.empty()) return {};
  const double most = quantile(after_ms, 0.999);
  add("processor time, p50", quantile(after_ms, 0.5), "ms", "", std::nullopt);
  add("processor time, p99.9", most, "ms", "<= 1", most <= 1.0);
  return addGivingUp(options, random, report);
}

}  // namespace underway::bench
