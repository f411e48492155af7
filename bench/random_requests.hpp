#pragma once

#include <random>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

/// A pose drawn uniformly from those where the first mode stands free in the bounds, with at least the
/// clearance given. Nothing if a million draws hold none.
[[nodiscard]] std::optional<Pose> randomPose(const Checker& checker, double margin_m,
                                             std::mt19937_64& random);

/// Requests in the first mode from so many random starts, each to so many random goals. Whether they can be
/// answered is not known. Fewer if there is no room.
[[nodiscard]] std::vector<std::vector<Request>> randomRequests(const Checker& checker, Policy policy,
                                                               std::size_t starts, std::size_t goals,
                                                               unsigned long seed);

}  // namespace underway::bench
