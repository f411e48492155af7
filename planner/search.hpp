#pragma once

#include <cstdint>
#include <memory_resource>
#include <optional>
#include <unordered_map>
#include <vector>

#include "planner/draft.hpp"
#include "planner/interrupt.hpp"
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

/// Remembers which links are free, over all searches on one draft: those that are not checked yet, and all
/// where more clearance is asked for than they were checked with; and how far what comes by them can turn.
/// For one thread.
class LinkChecks {
 public:
  LinkChecks(const Draft& graph, const Checker& checker) : graph_(graph), checker_(checker) {}
  /// Whether a link is free by a way, keeping what `legs` asks for.
  [[nodiscard]] bool isFree(Roadmap::LinkId link, std::size_t way, const Legs& legs);
  /// How far a stance can be turned, of the state with a number that all searches have for it.
  [[nodiscard]] TurningRoom roomOf(std::uint32_t state, const Roadmap::Place& place, const Stance& stance,
                                   const Legs& legs);

 private:
  /// What is free with a clearance is free with less, what is blocked is blocked with more.
  struct Known {
    double free_at_m = -1.0;
    double blocked_at_m = 1e300;
  };
  struct Room {
    double at_least_m = -1.0;  // of clearance
    TurningRoom room;
  };
  const Draft& graph_;
  const Checker& checker_;
  std::pmr::monotonic_buffer_resource memory_;  // given back at once: there are thousands
  std::pmr::unordered_map<std::uint64_t, Known> known_{&memory_};
  std::pmr::unordered_map<std::uint32_t, Room> rooms_{&memory_};
};

/// The cheapest way to any of the goals, by A* under the policy of `stances` with the Guide as its bound;
/// empty when there is none that costs less than `below`, or it was interrupted. Links that are not checked
/// yet are checked when they come up first in the queue, so that few need to be. `nearest`, if given, is set
/// to the pose nearest the goal that was reached.
[[nodiscard]] std::optional<Passage> search(const Draft& graph, const Stances& stances, const Robot& robot,
                                            LinkChecks& checks, const Target& target, Interrupt& interrupt,
                                            Pose* nearest = nullptr, Cost below = Cost::most());

}  // namespace underway
