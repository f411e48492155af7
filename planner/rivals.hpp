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

  /// The table is told which states are surpassed; it must outlive it.
  Rivals(std::size_t places, StateTable& states) : states_(states), last_(places, kNoState) {}

  /// Of a place, in no order: visit(state, stance, cost) until it returns true; whether it did.
  template <class Visit>
  bool anyAt(PlaceId place, const Visit& visit) const {
    for (std::uint32_t i = last_[place]; i != kNoState; i = rivals_[i].before)
      if (visit(rivals_[i].state, rivals_[i].stance, rivals_[i].cost)) return true;
    return false;
  }

  /// Whether one of a place's surpasses a state that comes there in a stance, at a cost.
  [[nodiscard]] bool surpass(PlaceId place, const Legs& legs, const Stance& stance, Cost cost) const {
    return anyAt(place, [&](StateId, const Stance& from, Cost its) {
      return its <= cost && its + legs.changeCost(from, stance) <= cost;
    });
  }

  void add(PlaceId place, StateId state, const Stance& stance, Cost cost) {
    rivals_.push_back({cost, stance, state, last_[place]});
    last_[place] = static_cast<std::uint32_t>(rivals_.size() - 1);
  }

  /// Adds a state that comes to cost so much, at a place where all changes of `legs` are free, and marks
  /// those that it surpasses. False when another surpasses it.
  bool compete(PlaceId place, const Legs& legs, StateId state, const Stance& stance, Cost cost) {
    for (std::uint32_t* at = &last_[place]; *at != kNoState;) {
      const Rival& other = rivals_[*at];
      bool gives_way = other.state == state;  // it costs less now
      if (!gives_way) {                       // only the cheaper of two can surpass the other
        if (other.cost <= cost && other.cost + legs.changeCost(other.stance, stance) <= cost) return false;
        gives_way = cost <= other.cost && cost + legs.changeCost(stance, other.stance) <= other.cost;
        if (gives_way) states_[other.state].is_surpassed = 1;
      }
      if (gives_way)
        *at = other.before;
      else
        at = &rivals_[*at].before;
    }
    add(place, state, stance, cost);
    return true;
  }

 private:
  struct Rival {
    Cost cost;
    Stance stance;
    StateId state;
    std::uint32_t before;  // at the same place
  };
  StateTable& states_;
  std::vector<std::uint32_t> last_;  // of each place, in rivals_
  std::vector<Rival> rivals_;
};

}  // namespace underway
