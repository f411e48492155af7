#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/peer.hpp"

namespace underway::bench {

/// The name under which our own planner runs.
inline constexpr const char* kOwnName = "underway";

/// Our own planner on the same task: from the world in memory to its first certified plan, then the plans of
/// ever denser roadmaps until the limit.
[[nodiscard]] Run runOwn(const Task& task);

/// All runs of one query, by planner.
struct Race {
  std::string query;
  double oracle_s = 0.0;  ///< the best plan's time
  std::map<std::string, std::vector<Run>> runs;
};

/// When a run had its first plan [s]; empty: never.
[[nodiscard]] std::optional<double> firstTime(const Run& run);
/// When it had a plan that takes no longer than this [s].
[[nodiscard]] std::optional<double> timeWithin(const Run& run, double cost_s);
/// The cost of its best plan at a time [s].
[[nodiscard]] std::optional<double> costAt(const Run& run, double time_s);

/// The p-th quantile of times of which some are never: infinite if that one is.
[[nodiscard]] double quantileOf(const std::vector<std::optional<double>>& times, double p);

}  // namespace underway::bench
