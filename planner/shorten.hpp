#pragma once

#include <optional>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/passage.hpp"
#include "planner/stances.hpp"

namespace underway {

/// What a shortened passage must keep.
struct Keeping {
  double start_m = 0.0;  ///< clearance on motions that begin at the start [m]
  double goal_m = 0.0;   ///< clearance on motions that end at the goal [m]
};

/// A passage, of whatever policy, made shorter under that of `stances`: stops are left out, moved and added,
/// and crossings moved along and beside their lines, as long as that helps. Steps become smaller from round
/// to round. Each round makes small changes one at a time (Nudge). Where legs are left that the policy counts
/// before any time, coarse rounds also lay a corridor of choices round the passage and take the cheapest way
/// through it, in which all moves at once. When interrupted, the best so far.
[[nodiscard]] Passage shortened(const Checker& checker, const Stances& stances, Passage passage,
                                const Keeping& keeping, Interrupt& interrupt);

/// The same by small steps alone: for a passage that has been shortened under another policy.
[[nodiscard]] Passage polished(const Checker& checker, const Stances& stances, Passage passage,
                               const Keeping& keeping, Interrupt& interrupt);

/// A passage beside one that comes closer to something than the clearance that `stances` ask for: all its
/// stops and crossings moved at once, by several steps. The cheapest of those with the largest step that
/// gives any; empty when none does or it was interrupted.
[[nodiscard]] std::optional<Passage> widened(const Checker& checker, const Stances& stances, Passage passage,
                                             const Keeping& keeping, Interrupt& interrupt);

}  // namespace underway
