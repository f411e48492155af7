#include "bench/race.hpp"

#include <limits>

#include "bench/report.hpp"
#include "planner/planner.hpp"

namespace underway::bench {
namespace {

constexpr double kDenser = 2.0;  // each roadmap after the first

}  // namespace

Run runOwn(const Task& task) {
  using Seconds = std::chrono::duration<double>;
  const auto start = Planner::Clock::now();
  const auto deadline = start + std::chrono::duration_cast<Planner::Clock::duration>(Seconds(task.limit_s));
  Run run;
  GrowthSettings settings{task.seed, GrowthSettings{}.sites_per_m2};
  while (Planner::Clock::now() < deadline) {
    Planner planner(task.world, task.robot, settings);
    const auto plan = planner.plan(task.request, deadline);
    const double now_s = Seconds(Planner::Clock::now() - start).count();
    if (plan && now_s <= task.limit_s &&
        (run.progress.empty() || plan->total_time_s < run.progress.back().cost_s))
      run.progress.push_back({now_s, plan->total_time_s});
    settings.sites_per_m2 *= kDenser;
  }
  run.took_s = Seconds(Planner::Clock::now() - start).count();
  return run;
}

std::optional<double> firstTime(const Run& run) {
  return timeWithin(run, std::numeric_limits<double>::infinity());
}

std::optional<double> timeWithin(const Run& run, double cost_s) {
  for (const Sample& sample : run.progress)
    if (sample.cost_s <= cost_s) return sample.time_s;
  return std::nullopt;
}

std::optional<double> costAt(const Run& run, double time_s) {
  std::optional<double> cost_s;
  for (const Sample& sample : run.progress)
    if (sample.time_s <= time_s) cost_s = sample.cost_s;
  return cost_s;
}

double quantileOf(const std::vector<std::optional<double>>& times, double p) {
  std::vector<double> numbers;
  for (const auto& time : times) numbers.push_back(time.value_or(std::numeric_limits<double>::infinity()));
  return quantile(std::move(numbers), p);
}

}  // namespace underway::bench
