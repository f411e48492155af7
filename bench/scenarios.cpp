#include "bench/scenarios.hpp"

#include <array>
#include <chrono>
#include <memory>

#include "bench/requests.hpp"
#include "geometry/map.hpp"
#include "planner/planner.hpp"

namespace underway::bench {
namespace {

constexpr unsigned long kSeeds = 50;
constexpr std::array kMaps{"scenario1", "scenario2a", "scenario2b", "scenario3"};
constexpr double kLongest_ms = 100.0;  // that scenario 3 may take

struct Runs {
  unsigned long solved = 0;
  std::vector<double> took_ms;
  std::vector<double> plan_s;
};

Runs runsOf(const Map& map, const std::shared_ptr<const Robot>& robot,
            const std::function<void(double)>& progress) {
  const auto world = std::make_shared<const World>(map.world);
  const Request request = requestOf(map.queries.front(), *robot);
  Runs runs;
  for (unsigned long seed = 1; seed <= kSeeds; ++seed) {
    const auto start = Planner::Clock::now();
    Planner planner(world, robot, {seed, GrowthSettings{}.sites_per_m2});
    const auto plan = planner.plan(request, start + std::chrono::seconds(10));
    runs.took_ms.push_back(std::chrono::duration<double, std::milli>(Planner::Clock::now() - start).count());
    if (plan) {
      ++runs.solved;
      runs.plan_s.push_back(plan->total_time_s);
    }
    progress(static_cast<double>(seed) / kSeeds);
  }
  return runs;
}

void addRows(const std::string& map, const Runs& runs, Report& report) {
  const auto add = [&](const std::string& what, double value, const char* unit, const char* goal,
                       std::optional<bool> met) {
    report.rows.push_back({map + ", cold: " + what, value, unit, goal, met, 1, kSeeds, {}, {}});
  };
  add("solved", static_cast<double>(runs.solved), "of 50 seeds", "50", runs.solved == kSeeds);
  const bool is_timed = map == "scenario3";
  const double longest = quantile(runs.took_ms, 1.0);
  add("world to certified plan, p50", quantile(runs.took_ms, 0.5), "ms", "", std::nullopt);
  add("world to certified plan, longest", longest, "ms", is_timed ? "< 100" : "",
      is_timed ? std::optional(longest < kLongest_ms) : std::nullopt);
  if (runs.plan_s.empty()) return;
  const double best = quantile(runs.plan_s, 0.0);
  add("plan's time over the best seed's, p50", quantile(runs.plan_s, 0.5) / best, "", "", std::nullopt);
  add("plan's time over the best seed's, p95", quantile(runs.plan_s, 0.95) / best, "", "", std::nullopt);
}

}  // namespace

Expected<Report> scenarios(const std::filesystem::path& data, const std::function<void(double)>& progress) {
  const auto robot = readRobot(data / "robots" / "nao.yaml");
  if (!robot) return tl::unexpected(robot.error());
  const auto shared = std::make_shared<const Robot>(*robot);
  Report report{"scenarios", {}};
  for (std::size_t i = 0; i < kMaps.size(); ++i) {
    const auto map = readMap(data / "maps" / (std::string(kMaps[i]) + ".yaml"));
    if (!map) return tl::unexpected(map.error());
    const auto share = [&](double done) { progress((static_cast<double>(i) + done) / kMaps.size()); };
    addRows(kMaps[i], runsOf(*map, shared, share), report);
  }
  return report;
}

}  // namespace underway::bench
