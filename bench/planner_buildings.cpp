#include <array>

#include "bench/oracle.hpp"
#include "bench/planner_parts.hpp"
#include "bench/random_requests.hpp"

namespace underway::bench {
namespace {

constexpr unsigned long kSeed = 1;
constexpr std::chrono::seconds kDeadline{1};

struct Building {
  const char* name;
  const char* file;  // in the folder of maps
  std::optional<double> resolution_m;
};
constexpr std::array kBuildings{Building{"Willow", "willow_0.05/willow-full-0.05.pgm", 0.05},
                                Building{"3NE", "utexas_gdc_3ne/3ne.yaml", std::nullopt}};

struct Asked {
  std::size_t queries = 0;
  std::size_t solved = 0;
  std::size_t at_first_try = 0;  ///< without growing the roadmap
  std::vector<double> ratios;    ///< cost over the oracle's
  std::vector<double> call_us;
};

/// Requests from a start that the oracle can answer, and its answers; none if the start is shut in.
struct Answered {
  std::vector<Request> requests;
  std::vector<Route> routes;
};

Answered answered(Oracle& oracle, const std::vector<Request>& requests, std::size_t wanted,
                  const Progress& progress) {
  Answered result;
  const auto routes = oracle.routes(requests, progress, wanted);
  for (std::size_t i = 0; i < routes.size() && result.requests.size() < wanted; ++i) {
    if (routes[i].empty()) continue;
    result.requests.push_back(requests[i]);
    result.routes.push_back(routes[i]);
  }
  return result;
}

void ask(Planner& planner, const Answered& answered, Asked& asked) {
  const Robot& robot = planner.checker()->robot();
  for (std::size_t i = 0; i < answered.requests.size(); ++i) {
    const auto start = Planner::Clock::now();
    const auto batches = planner.roadmap()->batches;
    const auto plan = planner.plan(answered.requests[i], start + kDeadline);
    const std::chrono::duration<double, std::micro> took = Planner::Clock::now() - start;
    ++asked.queries;
    if (!plan) continue;
    ++asked.solved;
    asked.at_first_try += plan->stats.batches == batches ? 1 : 0;
    asked.call_us.push_back(took.count());
    asked.ratios.push_back(
        costRatio(robot, answered.requests[i].policy, motionsOf(*plan), answered.routes[i]));
  }
}

void addRows(const std::string& building, double roadmap_ms, const Asked& asked, Report& report) {
  const auto add = [&](const std::string& what, double value, const char* unit, const char* goal = "",
                       std::optional<bool> met = std::nullopt) {
    report.rows.push_back(
        {building + ", NAO: " + what, value, unit, goal, met, kSeed, asked.queries, {}, {}});
  };
  add("roadmap", roadmap_ms, "ms", "< 1000", roadmap_ms < 1000.0);
  const auto percent = [&](std::size_t part) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(asked.queries);
  };
  if (asked.queries == 0) return;
  add("solved at the first try", percent(asked.at_first_try), "%", ">= 99.5",
      percent(asked.at_first_try) >= 99.5);
  add("solved within 1 s", percent(asked.solved), "%");
  if (asked.ratios.empty()) return;
  const double p50 = quantile(asked.ratios, 0.5);
  add("cost over the oracle's, p50", p50, "", "<= 1.05", p50 <= 1.05);
  add("cost over the oracle's, p95", quantile(asked.ratios, 0.95), "");
  add("cost over the oracle's, most", quantile(asked.ratios, 1.0), "");
  add("cost over the oracle's, least", quantile(asked.ratios, 0.0), "");
  add("warm query, whole call, p50", quantile(asked.call_us, 0.5), "us");
  add("warm query, whole call, p99", quantile(asked.call_us, 0.99), "us");
}

}  // namespace

Expected<void> addBuildings(const PlannerOptions& options, Report& report, const Progress& progress) {
  if (options.maps2d.empty()) return {};
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  const std::size_t starts = options.quick ? 1 : 10;
  const std::size_t goals = options.quick ? 10 : 100;
  for (std::size_t b = 0; b < kBuildings.size(); ++b) {
    MapOptions read;
    read.resolution_m = kBuildings.at(b).resolution_m;
    auto map = readMap(options.maps2d / kBuildings.at(b).file, read);
    if (!map) return tl::unexpected(map.error());
    const auto world = std::make_shared<const World>(std::move(map->world));
    const auto started = Planner::Clock::now();
    const auto planner = preparedPlanner(world, *robot);
    const std::chrono::duration<double, std::milli> roadmap = Planner::Clock::now() - started;
    Oracle oracle(*planner->checker(), buildingOracle());
    Asked asked;
    std::size_t open = 0;  // starts that were not shut in
    for (const auto& requests :
         randomRequests(*planner->checker(), Policy::kFastest, 4 * starts, 2 * goals, kSeed)) {
      const auto share = [&](double done) {
        progress((static_cast<double>(b) + (static_cast<double>(open) + done) / static_cast<double>(starts)) /
                 kBuildings.size());
      };
      const Answered known = answered(oracle, requests, goals, share);
      if (known.requests.size() < goals) continue;
      ask(*planner, known, asked);
      if (++open == starts) break;
    }
    addRows(kBuildings.at(b).name, roadmap.count(), asked, report);
  }
  return {};
}

}  // namespace underway::bench
