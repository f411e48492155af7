#pragma once

#include <optional>

#include "geometry/checker.hpp"
#include "planner/draft.hpp"
#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/search.hpp"

namespace underway {

/// A draft laid over the roadmap that holds a start and its goals, and where they are in it.
struct Attached {
  Draft graph;
  Target target;
};

/// How hard to try: with the nearest places alone, or with a small roadmap of its own round each end, for
/// ends so cluttered that no straight leg leaves them.
enum class Effort { kNearest, kLocalRoadmap };

/// Attaches a request's start and goals to a roadmap without touching it: to their nearest places, straight
/// out of places too tight to turn in, and, in or into a mode that cannot turn, along its line. Legs are left
/// unchecked, for the search to check those it wants. Empty when interrupted. The roadmap must outlive it.
///
/// Precondition: start and goals are free and in bounds.
[[nodiscard]] std::optional<Attached> attach(const Checker& checker, const Stances& stances,
                                             const Roadmap& roadmap, const Request& request, Effort effort,
                                             Interrupt& interrupt);

}  // namespace underway
