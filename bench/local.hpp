#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

struct LocalOptions {
  std::filesystem::path data;  ///< folder with maps/ and robots/
  bool quick = false;          ///< a small share of the seeds
  std::string only;            ///< one part: its name; empty: all
  std::filesystem::path map;   ///< instead of all eight, where plans are driven
  unsigned long seed = 1;      ///< the first
  unsigned long seeds = 0;     ///< how many; 0: as many as each figure asks for
};

/// The local layer's figures: GODZILA's optimum against a minimiser, a tick's time, GODZILA alone in the
/// thesis' arenas and in traps, and plans executed by a simulated robot with honest noise. `progress` is told
/// of each part by itself, `tell` in a sentence of each run that did not go as it should, so that it can be
/// driven again. Errors: as of readMap and readRobot; kInvalidRequest for a part that does not exist, or a
/// map that asks for nothing that can be answered.
[[nodiscard]] Expected<Report> local(const LocalOptions& options, const std::function<void(double)>& progress,
                                     const std::function<void(const std::string&)>& tell);

/// Whether a part, or all of them together if none is named, is driven on maps alone, so that one may be
/// chosen.
[[nodiscard]] bool isOnMaps(std::string_view part);

/// One after the other, for `only`.
[[nodiscard]] std::vector<std::string> localParts();

}  // namespace underway::bench
