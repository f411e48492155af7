#pragma once

#include <filesystem>
#include <functional>

#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

/// The OBB paper's scenarios, each from nothing: from the world in memory to a certified plan, roadmap
/// included, with seeds 1 to 50, on one thread. `data` is the folder that holds maps/ and robots/. Errors: as
/// of readMap and readRobot.
[[nodiscard]] Expected<Report> scenarios(const std::filesystem::path& data,
                                         const std::function<void(double)>& progress);

}  // namespace underway::bench
