#pragma once

#include <cstddef>
#include <optional>

#include "geometry/checker.hpp"
#include "planner/plan.hpp"

namespace underway {

/// The first segment of a plan, from one on, that is no longer free in a world: the plan is stale. Empty
/// while it may be followed to its end. Every motion is checked exactly, nothing is planned; tens of
/// nanoseconds a segment.
///
/// Segments keep the robot's margin, but that those which leave the plan's start or come to its goal may be
/// as close as that pose is. Thread safety: may be called from any number of threads.
[[nodiscard]] std::optional<std::size_t> firstBroken(const Plan& plan, const Checker& checker,
                                                     std::size_t from_segment = 0);

}  // namespace underway
