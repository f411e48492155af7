#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "planner/legs.hpp"
#include "planner/roadmap.hpp"
#include "planner/state_table.hpp"

namespace underway {

/// The states that a search has reached at each place. One of them surpasses another where it can change into
/// it and still cost no more: then all that can be reached from the other can be reached from it, and the
/// other need not be followed.
class Rivals {
 public:
  using PlaceId = Roadmap::PlaceId;
  using StateId = StateTable::Id;

  /// The table holds what the states cost; it must outlive it.
  Rivals(std::size_t places, StateTable& states)
      : states_(states), last_(places, kNoState), cheapest_(places, Cost::most()) {}

  /// What the cheapest state at a place costs; Cost::most() if there is none.
  [[nodiscard]] Cost cheapestAt(PlaceId place) const { return cheapest_[place]; }

  /// Of a place, in no order: visit(state, stance) until it returns true; whether it did.
  template <class Visit>
  bool anyAt(PlaceId place, const Visit& visit) const {
    for (std::uint32_t i = last_[place]; i != kNoState; i = rivals_[i].before)
      if (visit(rivals_[i].state, rivals_[i].stance)) return true;
    return false;
  }

  void add(PlaceId place, StateId state, const Stance& stance, Cost cost) {
    cheapest_[place] = std::min(cheapest_[place], cost);
    rivals_.push_back({state, last_[place], stance});
    last_[place] = static_cast<std::uint32_t>(rivals_.size() - 1);
  }

  /// Adds a state that comes to cost so much, at a place where all changes of `legs` are free, and marks
  /// those that it surpasses. False when another surpasses it.
  bool compete(PlaceId place, const Legs& legs, StateId state, const Stance& stance, Cost cost) {
    for (std::uint32_t* at = &last_[place]; *at != kNoState;) {
      Rival& other = rivals_[*at];
      bool gives_way = other.state == state;  // it costs less now
      if (!gives_way) {
        SearchState& known = states_[other.state];
        if (known.cost + legs.changeCost(other.stance, stance) <= cost) return false;
        gives_way = cost + legs.changeCost(stance, other.stance) <= known.cost;
        if (gives_way) known.is_surpassed = 1;
      }
      if (gives_way)
        *at = other.before;
      else
        at = &other.before;
    }
    add(place, state, stance, cost);
    return true;
  }

 private:
  struct Rival {
    StateId state;
    std::uint32_t before;  // at the same place
    Stance stance;
  };
  StateTable& states_;
  std::vector<std::uint32_t> last_;  // of each place, in rivals_
  std::vector<Cost> cheapest_;       // at each place
  std::vector<Rival> rivals_;
};

}  // namespace underway
