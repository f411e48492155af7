#pragma once

#include <string>

#include "bench/race.hpp"

namespace underway::bench {

/// What a log says besides the runs.
struct LogHeading {
  std::string experiment;  ///< no spaces
  std::string setup;       ///< any lines
  std::string host;
  std::string started;     ///< date and time
  double limit_s = 0.0;    ///< per run
  unsigned long seed = 0;  ///< the first
};

/// The races as a log of OMPL's benchmarks, which ompl_benchmark_statistics.py and Planner Arena read: of
/// each planner the runs of all queries, with time to the first plan, time until within 10 % of the oracle,
/// the last cost over the oracle's, and that ratio over time.
[[nodiscard]] std::string toOmplLog(const LogHeading& heading, const std::vector<Race>& races);

/// The same runs as a table: query, planner, run, seconds, cost over the oracle's; a line for every better
/// plan.
[[nodiscard]] std::string toCsv(const std::vector<Race>& races);

}  // namespace underway::bench
