#include <algorithm>
#include <cmath>

#include "bench/planner_parts.hpp"
#include "bench/planners.hpp"
#include "bench/requests.hpp"

namespace underway::bench {
namespace {

constexpr unsigned long kSeeds = 1000;
constexpr unsigned long kQuickSeeds = 50;
constexpr std::chrono::seconds kDeadline{10};

/// How long each of OMPL's planners needs until its plan is within 10 % of the oracle's, against ours.
void addAgainstPeers(const PlannersOptions& options, Report& report, const Progress& progress) {
  const std::vector<Race> run = races(options, progress);
  if (run.empty()) return;
  const Race& race = run.front();
  const auto p50 = [&](const std::string& planner) {
    std::vector<std::optional<double>> times;
    for (const Run& one : race.runs.at(planner)) times.push_back(timeWithin(one, 1.1 * race.oracle_s));
    return 1e3 * quantileOf(times, 0.5);
  };
  const std::vector<std::string> peers = peerNames();
  const std::string best = *std::min_element(peers.begin(), peers.end(),
                                             [&](const auto& a, const auto& b) { return p50(a) < p50(b); });
  const bool is_never = !std::isfinite(p50(best));  // then it is at least the limit
  const double best_ms = is_never ? 1e3 * options.limit_s : p50(best);
  const double ratio = best_ms / p50(kOwnName);
  const std::string name = is_never ? "all of OMPL's, not yet at the limit" : "best of OMPL's: " + best;
  report.rows.push_back({"scenario 3, cold: within 10 % of the oracle, p50", p50(kOwnName), "ms", ">= 20",
                         ratio >= 20.0, 1, static_cast<unsigned long>(options.runs), Row::Peer{name, best_ms},
                         ratio});
}

}  // namespace

Expected<void> addCold(const PlannerOptions& options, Report& report, const Progress& progress) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  const auto map = readMap(options.data / "maps" / "scenario3.yaml");
  if (!map) return tl::unexpected(map.error());
  const auto world = std::make_shared<const World>(map->world);
  const Request request = requestOf(map->queries.front(), **robot);
  const unsigned long seeds = options.quick ? kQuickSeeds : kSeeds;
  std::vector<double> took_ms;
  unsigned long solved = 0;
  for (unsigned long seed = 1; seed <= seeds; ++seed) {
    const auto start = Planner::Clock::now();
    Planner planner(world, *robot, {seed, GrowthSettings{}.sites_per_m2});
    solved += planner.plan(request, start + kDeadline) ? 1 : 0;
    took_ms.push_back(std::chrono::duration<double, std::milli>(Planner::Clock::now() - start).count());
    progress(static_cast<double>(seed) / static_cast<double>(seeds));
  }
  const auto add = [&](const std::string& what, double value, const char* unit, const char* goal,
                       std::optional<bool> met) {
    report.rows.push_back({"scenario 3, cold: " + what, value, unit, goal, met, 1, seeds, {}, {}});
  };
  add("solved", 100.0 * static_cast<double>(solved) / static_cast<double>(seeds), "%", "100",
      solved == seeds);
  const double p50 = quantile(took_ms, 0.5);
  const double p99 = quantile(took_ms, 0.99);
  add("world to certified plan, p50", p50, "ms", "<= 5", p50 <= 5.0);
  add("world to certified plan, p99", p99, "ms", "<= 25", p99 <= 25.0);
  add("world to certified plan, longest", quantile(took_ms, 1.0), "ms", "", std::nullopt);
  addAgainstPeers({world, *robot, {{"scenario3", request}}, options.quick ? 3 : 20, 10.0, {}}, report,
                  progress);
  return {};
}

}  // namespace underway::bench
