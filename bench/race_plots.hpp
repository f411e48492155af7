#pragma once

#include <string>

#include "bench/race.hpp"

namespace underway::bench {

/// Pictures of races, as SVG files: a curve a planner, time from left to right on a logarithmic scale.
/// - first: the share of runs that have a plan by then
[[nodiscard]] std::string plotFirstPlan(const std::vector<Race>& races, double limit_s);
/// - within: the share of runs that have a plan within 10 % of the oracle's by then
[[nodiscard]] std::string plotWithinTenPercent(const std::vector<Race>& races, double limit_s);
/// - cost: the median cost over the oracle's by then, from when half of the runs have a plan
[[nodiscard]] std::string plotCost(const std::vector<Race>& races, double limit_s);

}  // namespace underway::bench
