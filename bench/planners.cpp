#include "bench/planners.hpp"

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>

#include "bench/number_table.hpp"
#include "bench/ompl_log.hpp"
#include "bench/race_plots.hpp"

namespace underway::bench {
namespace {

constexpr double kRoom_m2 = 200.0;  // a larger floor is a building to the oracle
constexpr double kWithin = 1.1;     // of the oracle's cost

double secondsOf(const Robot& robot, const Route& route) {
  double sum = 0.0;
  for (const Motion& motion : route) sum += duration(robot, motion);
  return sum;
}

/// Times of all races, by planner.
template <class TimeOf>
std::vector<std::optional<double>> timesOf(const std::vector<Race>& races, const std::string& planner,
                                           const TimeOf& time_of) {
  std::vector<std::optional<double>> times;
  for (const Race& race : races)
    for (const Run& run : race.runs.at(planner)) times.push_back(time_of(race, run));
  return times;
}

std::optional<double> first(const Race& /*race*/, const Run& run) { return firstTime(run); }
std::optional<double> within(const Race& race, const Run& run) {
  return timeWithin(run, kWithin * race.oracle_s);
}

double percentSolved(const std::vector<Race>& races, const std::string& planner) {
  double solved = 0.0;
  double all = 0.0;
  for (const auto& time : timesOf(races, planner, first)) {
    solved += time ? 1.0 : 0.0;
    all += 1.0;
  }
  return 100.0 * solved / all;
}

void addRows(const std::vector<Race>& races, const std::string& peer, Report& report) {
  const auto samples = static_cast<unsigned long>(timesOf(races, peer, first).size());
  const auto against = [&](const std::string& what, double own_s, double peer_s) {
    report.rows.push_back(
        {what, 1e3 * own_s, "ms", "", {}, 1, samples, Row::Peer{peer, 1e3 * peer_s}, peer_s / own_s});
  };
  for (const double p : {0.5, 0.95}) {
    const std::string name = p == 0.5 ? ", p50" : ", p95";
    against("first plan" + name, quantileOf(timesOf(races, kOwnName, first), p),
            quantileOf(timesOf(races, peer, first), p));
    against("within 10 % of the oracle" + name, quantileOf(timesOf(races, kOwnName, within), p),
            quantileOf(timesOf(races, peer, within), p));
  }
  report.rows.push_back({"solved",
                         percentSolved(races, kOwnName),
                         "%",
                         "",
                         {},
                         1,
                         samples,
                         Row::Peer{peer, percentSolved(races, peer)},
                         {}});
}

Expected<void> write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.flush();
  if (!out) return fail(ErrorCode::kInvalidRequest, file.string() + ": cannot be written");
  return {};
}

std::string hostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : "unknown";
}

Expected<void> writeAll(const PlannersOptions& options, const std::vector<Race>& races) {
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  const std::string map = options.world->name();
  const std::string setup =
      fmt::format("map {}, robot {}, {} queries", map, options.robot->name, races.size());
  const LogHeading heading{map,
                           setup,
                           hostName(),
                           fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(std::time(nullptr))),
                           options.limit_s,
                           1};
  const std::array<std::pair<const char*, std::string>, 5> files{
      {{"planners.log", toOmplLog(heading, races)},
       {"planners.csv", toCsv(races)},
       {"first_plan.svg", plotFirstPlan(races, options.limit_s)},
       {"within_ten_percent.svg", plotWithinTenPercent(races, options.limit_s)},
       {"cost.svg", plotCost(races, options.limit_s)}}};
  for (const auto& [name, text] : files)
    if (const auto written = write(options.folder / name, text); !written) return written;
  return {};
}

}  // namespace

std::vector<Race> races(const PlannersOptions& options, const Progress& progress) {
  const Checker checker(options.world, options.robot);
  const Bounds& bounds = options.world->bounds();
  Oracle oracle(checker, bounds.width_m * bounds.height_m > kRoom_m2 ? buildingOracle() : roomOracle());
  std::vector<std::string> peers = peerNames();
  std::vector<Race> races;
  double done = 0.0;
  for (const auto& [name, query] : options.queries) {
    Request request = query;
    request.policy = Policy::kFastest;
    const Route best = oracle.route(request);
    const double step =
        1.0 / static_cast<double>(options.queries.size() * static_cast<std::size_t>(options.runs));
    if (best.empty()) {
      done += step * options.runs;
      continue;
    }
    Race race{name, secondsOf(*options.robot, best), {}};
    for (int i = 0; i < options.runs; ++i) {
      const Task task{options.world, options.robot, request, options.limit_s,
                      static_cast<unsigned long>(i + 1)};
      race.runs[kOwnName].push_back(runOwn(task));
      for (const std::string& peer : peers) race.runs[peer].push_back(runPeer(peer, task));
      progress(done += step);
    }
    races.push_back(std::move(race));
  }
  return races;
}

Expected<Report> planners(const PlannersOptions& options, const Progress& progress) {
  const std::vector<Race> run = races(options, progress);
  if (run.empty())
    return fail(ErrorCode::kInvalidRequest,
                "no query has an answer; name a map with queries, or --queries FILE");
  Report report{"planners", {}};
  for (const std::string& peer : peerNames()) addRows(run, peer, report);
  if (options.folder.empty()) return report;
  if (const auto written = writeAll(options, run); !written) return tl::unexpected(written.error());
  return report;
}

Expected<std::vector<std::pair<std::string, Request>>> readQueries(const std::filesystem::path& file) {
  static const std::vector<std::string> kColumns{"start_x", "start_y", "start_yaw",
                                                 "goal_x",  "goal_y",  "goal_yaw"};
  const auto rows = readNumbers(file, kColumns);
  if (!rows) return tl::unexpected(rows.error());
  std::vector<std::pair<std::string, Request>> queries;
  for (const auto& row : *rows)
    queries.emplace_back(std::to_string(queries.size()),
                         Request{{row[0], row[1], row[2]}, 0, {row[3], row[4]}, row[5], 0, Policy::kFastest});
  return queries;
}

}  // namespace underway::bench
