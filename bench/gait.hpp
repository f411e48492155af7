#pragma once

#include <filesystem>
#include <functional>

#include "bench/report.hpp"
#include "geometry/error.hpp"

namespace underway::bench {

/// The crawl in its own model, without physics: the nominal gait's figures, what optimising is worth, what
/// each gait of the library (`data`/gaits) costs and takes, and how fast all that is computed. Torques are
/// those of the author's robot, NAO V4.0. Errors: kInvalidRequest when a gait cannot be read.
[[nodiscard]] Expected<Report> gait(const std::filesystem::path& data,
                                    const std::function<void(double)>& progress);

}  // namespace underway::bench
