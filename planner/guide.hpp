#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planner/draft.hpp"
#include "planner/interrupt.hpp"
#include "planner/sites.hpp"

namespace underway {

/// A lower bound of what is left from each place to the nearest of the goals: the cheapest way over links, as
/// if turning and changing modes cost nothing. It is consistent under every policy, since a change at a place
/// costs nothing less. Worked out as far as it is asked for, by A* from all goals towards the start.
class Guide {
 public:
  /// All must outlive it.
  Guide(const Draft& graph, const Stances& stances, Roadmap::PlaceId start,
        std::span<const Roadmap::PlaceId> goals, Interrupt& interrupt);

  /// Cost::most() where no links lead to the goal, and where it is not known when interrupted. If it is more
  /// than `enough`, it may come out too low, but above that: so much less work it is.
  [[nodiscard]] Cost from(Roadmap::PlaceId place, Cost enough = Cost::most());
  /// The same without any work: what is known of it, or less.
  [[nodiscard]] Cost atLeastFrom(Roadmap::PlaceId place) const;
  /// Works out all places by which a way from the start may cost less.
  void workOut(Cost below);

 private:
  struct Open {
    Cost bound;
    Roadmap::PlaceId place;
    bool operator<(const Open& other) const {
      return bound > other.bound || (bound == other.bound && place > other.place);
    }
  };
  void settleNext();
  void reach(Roadmap::PlaceId place, Cost cost);
  /// The least that the way from the start to a place costs.
  [[nodiscard]] Cost wayTo(Roadmap::PlaceId place) const {
    return Cost::time(static_cast<std::uint64_t>(distance(graph_.place(place).at, start_) * us_per_m_));
  }

  const Draft& graph_;
  const Stances& stances_;
  Interrupt& interrupt_;
  Point start_;
  double us_per_m_;  // at the robot's highest speed
  std::vector<Cost> least_;
  std::vector<char> is_settled_;
  std::vector<Open> open_;  // a heap
};

}  // namespace underway
