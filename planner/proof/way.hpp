#pragma once

#include <optional>
#include <vector>

#include "planner/interrupt.hpp"
#include "planner/proof/relaxation.hpp"

namespace underway {

/// A cell on a way, and how the way leaves it: by an exit, or to a neighbour.
struct Step {
  Relaxation::Place place;
  std::optional<std::size_t> exit;  ///< index into the stance's exits
};

/// From the start to the goal through open cells; of all ways that through the fewest and largest undecided
/// ones. Nothing if there is none, or when interrupted (ask the interrupt).
[[nodiscard]] std::optional<std::vector<Step>> findWay(const Relaxation& relaxation, Interrupt& interrupt);

/// The obstacles, as indices into the world's, that are on the way from start to goal that has the fewest of
/// them on it; nothing if all ways leave the bounds, or when interrupted.
[[nodiscard]] std::optional<std::vector<std::size_t>> findFewestBlockers(Relaxation& relaxation,
                                                                         Interrupt& interrupt);

}  // namespace underway
