#pragma once

#include <filesystem>
#include <utility>

#include "bench/oracle.hpp"
#include "bench/race.hpp"
#include "bench/report.hpp"

namespace underway::bench {

struct PlannersOptions {
  std::shared_ptr<const World> world;
  std::shared_ptr<const Robot> robot;
  std::vector<std::pair<std::string, Request>> queries;  ///< by name
  int runs = 20;                                         ///< of each planner on each query
  double limit_s = 5.0;                                  ///< of each run
  std::filesystem::path folder;  ///< for the log, the table and the pictures; empty: none are written
};

/// Our planner and OMPL's on the same queries, all cold and on one processor: when the first plan is there,
/// when one within 10 % of the oracle's, how many runs are solved. One row for each figure and peer, ours
/// against theirs. Queries that the oracle cannot answer are left out. Under kFastest: the time a plan takes
/// is what all of them can compare. Errors: kInvalidRequest if no query is left, or the folder cannot be
/// written.
[[nodiscard]] Expected<Report> planners(const PlannersOptions& options, const Progress& progress);

/// The runs alone.
[[nodiscard]] std::vector<Race> races(const PlannersOptions& options, const Progress& progress);

/// Queries of a comma-separated file with columns start_x, start_y, start_yaw, goal_x, goal_y, goal_yaw, in
/// the robot's first mode, named by their number. Errors: as of readNumbers.
[[nodiscard]] Expected<std::vector<std::pair<std::string, Request>>> readQueries(
    const std::filesystem::path& file);

}  // namespace underway::bench
