#include <array>

#include "bench/planner_parts.hpp"
#include "bench/random_requests.hpp"
#include "bench/requests.hpp"

namespace underway::bench {
namespace {

constexpr unsigned long kSeed = 1;
constexpr std::chrono::seconds kDeadline{10};
constexpr int kFittings = 8;  // of the density, until the roadmap has the size

struct Size {
  double nodes;
  double goal_us;
};
constexpr std::array kSizes{Size{1000, 50}, Size{5000, 200}};

struct Times {
  std::vector<double> query_us;  // without the certificate
  std::vector<double> call_us;   // with it
};

Times timed(Planner& planner, const std::vector<Request>& requests, std::size_t rounds) {
  Times times;
  for (std::size_t round = 0; round < rounds; ++round)
    for (const Request& request : requests) {
      const auto start = Planner::Clock::now();
      const auto plan = planner.plan(request, start + kDeadline);
      const std::chrono::duration<double, std::micro> took = Planner::Clock::now() - start;
      if (!plan || round == 0) continue;  // the first round fills caches and may grow
      times.query_us.push_back(plan->stats.query_us);
      times.call_us.push_back(took.count());
    }
  return times;
}

double nodesOf(Planner& planner, const Request& request) {
  const auto plan = planner.plan(request, Planner::Clock::now() + kDeadline);
  return plan ? static_cast<double>(plan->stats.nodes) : 0.0;
}

/// A planner whose roadmap has about so many nodes, by trying densities.
std::unique_ptr<Planner> plannerOfSize(const std::shared_ptr<const World>& world,
                                       const std::shared_ptr<const Robot>& robot, const Request& request,
                                       double nodes) {
  GrowthSettings settings{kSeed, GrowthSettings{}.sites_per_m2};
  std::unique_ptr<Planner> planner;
  for (int i = 0; i < kFittings; ++i) {
    planner = preparedPlanner(world, robot, settings);
    const double has = nodesOf(*planner, request);
    if (has <= 0.0 || (has > 0.9 * nodes && has < 1.1 * nodes)) break;
    settings.sites_per_m2 *= nodes / has;
  }
  return planner;
}

void addRow(Report& report, std::string what, double value, const char* unit, double goal_us,
            std::size_t samples) {
  const bool is_asked = goal_us > 0.0;
  report.rows.push_back({std::move(what),
                         value,
                         unit,
                         is_asked ? "<= " + std::to_string(static_cast<int>(goal_us)) : "",
                         is_asked ? std::optional(value <= goal_us) : std::nullopt,
                         kSeed,
                         samples,
                         {},
                         {}});
}

}  // namespace

Expected<void> addWarm(const PlannerOptions& options, Report& report, const Progress& progress) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  const auto map = readMap(options.data / "maps" / "scenario3.yaml");
  if (!map) return tl::unexpected(map.error());
  const auto world = std::make_shared<const World>(map->world);
  const std::size_t rounds = options.quick ? 3 : 21;
  const Request paper = requestOf(map->queries.front(), **robot);
  std::vector<Request> requests{paper};
  const Checker checker(world, *robot);
  for (const auto& of_start : randomRequests(checker, Policy::kPriority, 10, 5, kSeed))
    requests.insert(requests.end(), of_start.begin(), of_start.end());
  double done = 0.0;
  for (const Size& size : kSizes) {
    const auto planner = plannerOfSize(world, *robot, paper, size.nodes);
    const Times times = timed(*planner, requests, rounds);
    const std::string what = "warm query, about " + std::to_string(static_cast<int>(size.nodes)) + " nodes: ";
    addRow(report, what + "nodes", nodesOf(*planner, paper), "", 0.0, 1);
    if (times.query_us.empty()) continue;
    addRow(report, what + "p50", quantile(times.query_us, 0.5), "us", size.goal_us, times.query_us.size());
    addRow(report, what + "p99", quantile(times.query_us, 0.99), "us", 0.0, times.query_us.size());
    addRow(report, what + "with certificate, p50", quantile(times.call_us, 0.5), "us", 0.0,
           times.call_us.size());
    progress(done += 1.0 / 3.0);
  }
  const auto planner = preparedPlanner(world, *robot);
  const Times times = timed(*planner, {paper}, options.quick ? 50 : 1000);
  if (times.call_us.empty()) return {};
  addRow(report, "scenario 3, warm query with certificate, p50", quantile(times.call_us, 0.5), "us", 200.0,
         times.call_us.size());
  addRow(report, "scenario 3, warm query with certificate, p99", quantile(times.call_us, 0.99), "us", 0.0,
         times.call_us.size());
  return {};
}

}  // namespace underway::bench
