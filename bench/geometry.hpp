#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

struct GeometryOptions {
  bool quick = false;          ///< a hundredth of the random cases
  std::filesystem::path grid;  ///< a grid map to load and ask poses of; empty: an office that is drawn
  std::optional<double> resolution_m;  ///< of the grid, if it is an image without its YAML
};

/// The collision engine: how exact it is against a slow reference, FCL's booleans beside it, and how fast
/// against FCL in the same run. Errors: as of readGrid and readMap.
[[nodiscard]] Expected<Report> geometry(const GeometryOptions& options,
                                        const std::function<void(double)>& progress);

}  // namespace underway::bench
