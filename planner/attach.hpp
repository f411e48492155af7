#pragma once

#include <memory>
#include <optional>

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/plan.hpp"
#include "planner/roadmap.hpp"

namespace underway {

/// A roadmap laid over the frozen one that holds a start and a goal, and where they are in it.
struct Attached {
  Roadmap roadmap;
  Roadmap::NodeId start = 0;
  Roadmap::PlaceId goal_place = 0;
  std::optional<Roadmap::NodeId> goal_node;  ///< empty: any heading will do
};

/// How hard to try: with the nearest places alone, or with a small roadmap of its own round each end, for
/// ends so cluttered that no straight connection leaves them.
enum class Effort { kNearest, kLocalRoadmap };

/// Attaches a request's start and goal to a roadmap without touching it: to their nearest places in every
/// mode they can change into where they are, straight out of places too tight to turn in, and, in or into a
/// mode that cannot turn, along its line. Connections are left unchecked, for the search to check those it
/// wants. Empty when interrupted.
///
/// Precondition: start and goal are free and in bounds.
[[nodiscard]] std::optional<Attached> attach(const Checker& checker, std::shared_ptr<const Roadmap> roadmap,
                                             const Request& request, Effort effort, Interrupt& interrupt);

}  // namespace underway
