#pragma once

#include <filesystem>

#include "bench/oracle/flood.hpp"
#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

struct PlannerOptions {
  std::filesystem::path data;    ///< folder with maps/ and robots/
  std::filesystem::path maps2d;  ///< folder with large grid maps; empty: their rows are left out
  bool quick = false;            ///< a small share of the cases
  double own_s = 0.0;            ///< the planner's own best after so long counts for the oracle too [s]
  std::string only;              ///< one part: its name; empty: all
};

/// The planner's figures: how fast cold and warm, how good against the oracle, how punctual, and how all that
/// grows. `progress` is told of each part by itself. Errors: as of readMap and readRobot; kInvalidRequest for
/// a part that does not exist.
[[nodiscard]] Expected<Report> planner(const PlannerOptions& options, const Progress& progress);

/// One after the other, for `only`.
[[nodiscard]] std::vector<std::string> plannerParts();

}  // namespace underway::bench
