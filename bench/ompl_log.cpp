#include "bench/ompl_log.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace underway::bench {
namespace {

constexpr const char* kRunProperties =
    "time REAL\nsolved BOOLEAN\ntime within ten percent REAL\nsolution cost REAL\nkilled BOOLEAN\n";
constexpr int kRunPropertyCount = 5;

/// Names of the planners, in one order for all queries.
std::vector<std::string> namesIn(const std::vector<Race>& races) {
  std::vector<std::string> names;
  for (const Race& race : races)
    for (const auto& [name, runs] : race.runs)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

template <class Each>
void forEachRun(const std::vector<Race>& races, const std::string& planner, const Each& each) {
  for (const Race& race : races)
    if (const auto runs = race.runs.find(planner); runs != race.runs.end())
      for (const Run& run : runs->second) each(race, run);
}

/// A number, or nothing: the reader takes an empty field for unknown.
std::string number(std::optional<double> value) { return value ? fmt::format("{}", *value) : ""; }

std::string lineOf(const Race& race, const Run& run) {
  const auto last = run.progress.empty() ? std::optional<double>()
                                         : std::optional(run.progress.back().cost_s / race.oracle_s);
  return fmt::format("{}; {:d}; {}; {}; {:d}; \n", number(firstTime(run)), !run.progress.empty(),
                     number(timeWithin(run, 1.1 * race.oracle_s)), number(last), run.was_killed);
}

std::string progressOf(const Race& race, const Run& run) {
  std::string line;
  for (const Sample& sample : run.progress)
    line += fmt::format("{},{},;", sample.time_s, sample.cost_s / race.oracle_s);
  return line + "\n";
}

std::string plannerOf(const std::vector<Race>& races, const std::string& name) {
  std::string lines;
  std::string progress;
  std::size_t runs = 0;
  forEachRun(races, name, [&](const Race& race, const Run& run) {
    lines += lineOf(race, run);
    progress += progressOf(race, run);
    ++runs;
  });
  std::string text = name + "\n0 common properties\n";
  text += fmt::format("{} properties for each run\n{}{} runs\n{}", kRunPropertyCount, kRunProperties, runs,
                      lines);
  text += fmt::format("2 progress properties for each run\ntime REAL\nbest cost REAL\n{} runs\n{}.\n", runs,
                      progress);
  return text;
}

}  // namespace

std::string toOmplLog(const LogHeading& heading, const std::vector<Race>& races) {
  const std::vector<std::string> names = namesIn(races);
  std::size_t most_runs = 0;
  double total_s = 0.0;
  for (const std::string& name : names) {
    std::size_t runs = 0;
    forEachRun(races, name, [&](const Race&, const Run& run) {
      ++runs;
      total_s += run.took_s;
    });
    most_runs = std::max(most_runs, runs);
  }
  std::string text =
      fmt::format("OMPL version 1.5.2\nExperiment {}\nRunning on {}\nStarting at {}\n<<<|\n{}\n|>>>\n",
                  heading.experiment, heading.host, heading.started, heading.setup);
  text += fmt::format("{} is the random seed\n{} seconds per run\n0 MB per run\n{} runs per planner\n",
                      heading.seed, heading.limit_s, most_runs);
  text +=
      fmt::format("{} seconds spent to collect the data\n0 enum types\n{} planners\n", total_s, names.size());
  for (const std::string& name : names) text += plannerOf(races, name);
  return text;
}

std::string toCsv(const std::vector<Race>& races) {
  std::string text = "query,planner,run,time_s,cost_over_oracle\n";
  for (const Race& race : races)
    for (const auto& [name, runs] : race.runs)
      for (std::size_t i = 0; i < runs.size(); ++i)
        for (const Sample& sample : runs[i].progress)
          text += fmt::format("{},{},{},{},{}\n", race.query, name, i, sample.time_s,
                              sample.cost_s / race.oracle_s);
  return text;
}

}  // namespace underway::bench
