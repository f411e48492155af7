#include "bench/peer_queries.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>

#include "bench/number_table.hpp"
#include "bench/oracle.hpp"
#include "geometry/map.hpp"
#include "planner/planner.hpp"

namespace underway::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kPrepare{10};  // at most
constexpr std::chrono::seconds kQuery{1};     // what the peers had
constexpr std::size_t kOracleQueries = 20;    // of each building, that the oracle answers too

struct Building {
  const char* name;
  const char* queries;  // in the folder of queries
  const char* map;      // in the folder of maps
};
constexpr std::array kBuildings{Building{"ilab", "ilab.csv", "gt_rail/ilab.yaml"},
                                Building{"3NE", "utexas_gdc_3ne.csv", "utexas_gdc_3ne/3ne.yaml"}};

/// One line of a file of queries.
struct PeerQuery {
  Pose start;
  Pose goal;
  double sbpl_s = 0.0;  ///< cost of SBPL's best plan within one second
  double best_s = 0.0;  ///< cost of the best plan of any peer
};

Expected<std::vector<PeerQuery>> readPeerQueries(const fs::path& file) {
  static const std::vector<std::string> kColumns{
      "start_x", "start_y",  "start_yaw",           "goal_x",
      "goal_y",  "goal_yaw", "sbpl_best_1s_cost_s", "best_known_cost_s"};
  const auto rows = readNumbers(file, kColumns);
  if (!rows) return tl::unexpected(rows.error());
  std::vector<PeerQuery> queries;
  for (const auto& row : *rows)
    queries.push_back({{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, row[6], row[7]});
  return queries;
}

/// The body that the peers moved.
Expected<Robot> peersRobot() {
  Mode walk;
  walk.name = "walk";
  walk.body_m = {{-0.13, 0.13}, {-0.195, 0.195}, {0.0, 0.5}};
  walk.speed_mps = {0.1, 0.1, 0.1, 0.1};
  walk.turn_speed_radps = 0.5;
  return checkedRobot({"peers_body", 0.0, {walk}, {}, {}});
}

Request requestOf(const PeerQuery& query) {
  return {query.start, 0, query.goal.position(), query.goal.yaw, 0, Policy::kFastest};
}

/// What was measured on one building.
struct Measured {
  double prepare_ms = 0.0;
  std::uint64_t nodes = 0;
  unsigned long asked = 0;
  std::vector<double> call_us;   // of the whole call, of each query that was solved
  std::vector<double> query_us;  // as the plan tells it
  std::vector<double> to_sbpl;   // cost over SBPL's
  std::vector<double> to_best;   // cost over the best peer's
};

/// What the best plans would cost, over SBPL's, and ours over theirs: how much there is to gain.
struct Best {
  std::vector<double> to_sbpl;
  std::vector<double> own_to_oracle;
};

using Milliseconds = std::chrono::duration<double, std::milli>;
using Microseconds = std::chrono::duration<double, std::micro>;

Measured measured(const World& world, const std::vector<PeerQuery>& queries, const Robot& robot,
                  const std::function<void(double)>& progress) {
  Measured result;
  Planner planner(std::make_shared<const World>(world), std::make_shared<const Robot>(robot));
  const auto started = Planner::Clock::now();
  planner.prepare(started + kPrepare);
  result.prepare_ms = Milliseconds(Planner::Clock::now() - started).count();
  for (const PeerQuery& query : queries) {
    const Request request = requestOf(query);
    const auto asked = Planner::Clock::now();
    const auto plan = planner.plan(request, asked + kQuery);
    const double took_us = Microseconds(Planner::Clock::now() - asked).count();
    progress(static_cast<double>(++result.asked) / static_cast<double>(queries.size()));
    if (!plan) continue;
    result.nodes = plan->stats.nodes;
    result.call_us.push_back(took_us);
    result.query_us.push_back(plan->stats.query_us);
    result.to_sbpl.push_back(plan->total_time_s / query.sbpl_s);
    result.to_best.push_back(plan->total_time_s / query.best_s);
  }
  return result;
}

Best bestOf(const World& world, const std::vector<PeerQuery>& queries, const Robot& robot,
            const std::function<void(double)>& progress) {
  Best best;
  Planner planner(std::make_shared<const World>(world), std::make_shared<const Robot>(robot));
  Oracle oracle(*planner.checker(), buildingOracle());
  const std::size_t asked = std::min(kOracleQueries, queries.size());
  for (std::size_t i = 0; i < asked; ++i) {
    const Request request = requestOf(queries[i]);
    const Route route = oracle.route(request);
    progress(static_cast<double>(i + 1) / static_cast<double>(asked));
    if (route.empty()) continue;
    double time_s = 0.0;
    for (const Motion& motion : route) time_s += duration(robot, motion);
    best.to_sbpl.push_back(time_s / queries[i].sbpl_s);
    const auto plan = planner.plan(request, Planner::Clock::now() + kPrepare);
    if (plan) best.own_to_oracle.push_back(plan->total_time_s / time_s);
  }
  return best;
}

void addRows(const std::string& name, const Best& best, Report& report) {
  if (best.to_sbpl.empty() || best.own_to_oracle.empty()) return;
  const auto add = [&](const char* what, double value) {
    report.rows.push_back(
        {name + ": " + what, value, "", "", {}, GrowthSettings{}.seed, best.to_sbpl.size(), {}, {}});
  };
  add("the oracle's cost over SBPL's best in 1 s, p50", quantile(best.to_sbpl, 0.5));
  add("the oracle's cost over SBPL's best in 1 s, p95", quantile(best.to_sbpl, 0.95));
  add("cost over the oracle's, p50", quantile(best.own_to_oracle, 0.5));
  add("cost over the oracle's, p95", quantile(best.own_to_oracle, 0.95));
  add("cost over the oracle's, least", quantile(best.own_to_oracle, 0.0));
}

void addRows(const std::string& name, const Measured& m, Report& report) {
  const auto add = [&](const std::string& what, double value, const char* unit, const char* goal = "",
                       std::optional<bool> met = std::nullopt) {
    report.rows.push_back(
        {name + ": " + what, value, unit, goal, met, GrowthSettings{}.seed, m.asked, {}, {}});
  };
  add("roadmap", m.prepare_ms, "ms");
  add("roadmap, nodes", static_cast<double>(m.nodes), "");
  const auto solved = static_cast<double>(m.call_us.size());
  add("solved", solved / static_cast<double>(m.asked) * 100.0, "%", "100", m.call_us.size() == m.asked);
  if (m.call_us.empty()) return;
  const auto times = [&](const char* what, const std::vector<double>& us) {
    add(std::string(what) + ", p50", quantile(us, 0.5), "us");
    add(std::string(what) + ", p95", quantile(us, 0.95), "us");
    add(std::string(what) + ", longest", quantile(us, 1.0), "us");
  };
  times("warm query, whole call", m.call_us);
  times("warm query, without the certificate", m.query_us);
  const double p50 = quantile(m.to_sbpl, 0.5);
  const double p95 = quantile(m.to_sbpl, 0.95);
  add("cost over SBPL's best in 1 s, p50", p50, "", "<= 0.98", p50 <= 0.98);
  add("cost over SBPL's best in 1 s, p95", p95, "", "<= 1.02", p95 <= 1.02);
  add("cost over SBPL's best in 1 s, most", quantile(m.to_sbpl, 1.0), "");
  add("cost over the best peer's, p50", quantile(m.to_best, 0.5), "");
  add("cost over the best peer's, p95", quantile(m.to_best, 0.95), "");
}

}  // namespace

Expected<Report> peerQueries(const PeerOptions& options, const std::function<void(double)>& progress) {
  const auto robot = peersRobot();
  if (!robot) return tl::unexpected(robot.error());
  const fs::path maps = options.maps2d.empty() ? options.peers / ".." / "maps" / "maps2d" : options.maps2d;
  Report report{"peers", {}};
  for (std::size_t i = 0; i < kBuildings.size(); ++i) {
    auto queries = readPeerQueries(options.peers / kBuildings[i].queries);
    if (!queries) return tl::unexpected(queries.error());
    if (options.quick) queries->resize((queries->size() + 4) / 5);
    const auto map = readMap(maps / kBuildings[i].map);
    if (!map) return tl::unexpected(map.error());
    const auto share = [&](double done) { progress((static_cast<double>(i) + done) / kBuildings.size()); };
    addRows(kBuildings[i].name, measured(map->world, *queries, *robot, share), report);
    if (!options.quick) addRows(kBuildings[i].name, bestOf(map->world, *queries, *robot, share), report);
  }
  return report;
}

}  // namespace underway::bench
