#pragma once

#include <memory>
#include <optional>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/proof/relaxation.hpp"

namespace underway::proof {

/// That no plan exists: a relaxation of the world (relaxation.hpp) in which the goal cannot be reached.
struct Proof {
  Relaxation relaxation;
};

/// A proof that no plan answers the request, under any reading of the formats; or nothing: one may exist, or
/// it was interrupted.
///
/// Cells of (x, y, yaw) are halved along the way that still seems open, coarse ones first, until there is
/// none. It gives up early when a way is left that nothing is known to block.
///
/// Preconditions: as `admitted` checks them. Thread safety: may be called from any number of threads, each
/// with an interrupt of its own.
[[nodiscard]] std::optional<Proof> proveNoPath(const Checker& checker, const Request& request,
                                               Interrupt& interrupt);

/// Whether no way is left in a relaxation, refined for it as far as it is worth: to so many cells at most.
[[nodiscard]] bool closes(Relaxation& relaxation, std::size_t most_cells, Interrupt& interrupt);

/// The least clearance that any segment of a plan must keep: the robot's margin, or what the start has, or
/// what a pose within the tolerance of a goal has at least, if that is less. Of no use when
/// interrupted.
[[nodiscard]] double leastMargin(const Checker& checker, const Request& request, Interrupt& interrupt);

}  // namespace underway::proof
