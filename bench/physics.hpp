#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

struct PhysicsOptions {
  std::filesystem::path data;  ///< the folder that holds robots/, maps/ and gaits/
  bool quick = false;          ///< 4 of the 20 seeds
  std::string pictures;        ///< write side views of what happened here; empty: none
  std::string only;            ///< one of physicsParts(); empty: all
};

/// What the bench can be told to measure alone.
[[nodiscard]] std::vector<std::string> physicsParts();

/// The crawl on a NAO in physics (sim/physics): advance, height, drift; 2 m with the heading kept and
/// without; slopes and curves; torques of the pushes at ten durations; going down and getting up; the
/// whole way under a table; missions by the executor. Twenty seeds: friction 0.4 to 1, servos' zeros and the
/// start off by a little. Errors: as of physics::makeModel; kInvalidRobot when a gait cannot be read;
/// kInvalidRequest when pictures cannot be written.
[[nodiscard]] Expected<Report> physics(const PhysicsOptions& options,
                                       const std::function<void(double)>& progress);

}  // namespace underway::bench
