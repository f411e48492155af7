#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "planner/draft.hpp"
#include "planner/interrupt.hpp"
#include "planner/link_checks.hpp"
#include "planner/passage.hpp"
#include "planner/sites.hpp"

namespace underway {

/// Where a search begins and what it is to find, in a draft over the roadmap.
struct Target {
  /// One of the goals, each of which will do.
  struct Goal {
    Roadmap::PlaceId place = 0;
    Stance stance;
    bool any_heading = false;
    std::uint32_t index = 0;  ///< in the request
  };
  Roadmap::PlaceId start = 0;
  Stance start_stance;
  std::vector<Goal> goals;
};

/// The cheapest way to any of the goals, by A* under the policy of `stances` with the Guide as its bound;
/// empty when there is none that costs less than `below`, or it was interrupted. Links that are not checked
/// yet are checked when they come up first in the queue, so that few need to be. `nearest`, if given, is set
/// to the pose nearest the goal that was reached.
[[nodiscard]] std::optional<Passage> search(const Draft& graph, const Stances& stances, const Robot& robot,
                                            LinkChecks& checks, const Target& target, Interrupt& interrupt,
                                            Pose* nearest = nullptr, Cost below = Cost::most());

}  // namespace underway
