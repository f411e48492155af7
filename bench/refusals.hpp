#pragma once

#include <filesystem>
#include <functional>

#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

/// How honest a 'no' is. In 100 rooms that a plan is found in, the need of their one passage is closed, so
/// that 1, 2, 5 or 10 cm are missing: how many are proven to have no plan within 10 s, and in what time; and
/// is what was closed what is blamed. And of 1000 rooms that a plan is found in, how many are 'proven' to
/// have none: 0, or the proof is worth nothing. `data` is the folder that holds robots/. Errors: as of
/// readRobot.
[[nodiscard]] Expected<Report> refusals(const std::filesystem::path& data,
                                        const std::function<void(double)>& progress);

}  // namespace underway::bench
