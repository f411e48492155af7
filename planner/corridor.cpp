#include "planner/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace underway {
namespace {

constexpr double kSamePoint_m = 1e-7;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A way to have come to an option.
struct State {
  std::uint32_t parent = kNone;
  std::uint32_t station = 0;
  std::uint32_t option = 0;
  std::uint32_t way = kNone;
  Stance arriving;
  Stance leaving;
  Cost cost;  // of all up to here, the option's motions included
  bool has_room = false;
  TurningRoom room = {};  // of `leaving`, if it is known
};

class Passing {
 public:
  Passing(const Corridor& corridor, Cost bound) : corridor_(corridor), bound_(bound) {
    for (const Station& station : corridor) {
      at_.emplace_back(station.options.size());
      turns_freely_.emplace_back(station.options.size(), -1);
      left_.emplace_back(station.options.size(), Cost::most());
    }
    lookBack();
  }

  std::optional<Passage> cheapest(Interrupt& interrupt) {
    const Option& start = corridor_.front().options.front();
    const Stance standing{start.out.yaw, start.out_mode};
    states_.push_back({kNone, 0, 0, kNone, standing, standing, start.cost, false, {}});
    at_[0][0].push_back(0);
    for (std::uint32_t from = 0; from + 1 < corridor_.size(); ++from) {
      for (std::uint32_t option = 0; option < corridor_[from].options.size(); ++option) {
        if (at_[from][option].empty()) continue;
        if (interrupt.isDueNow()) return std::nullopt;
        leave(from, option);
      }
    }
    const std::vector<std::uint32_t>& ends = at_.back()[0];
    const auto best = std::min_element(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
      return states_[a].cost < states_[b].cost;
    });
    if (best == ends.end() || states_[*best].cost >= bound_) return std::nullopt;
    return passageTo(*best);
  }

 private:
  /// What is left from each option to the goal, at least: legs the cheapest way, nothing in the way of them,
  /// and no turns.
  void lookBack() {
    left_.back()[0] = Cost();
    for (std::size_t from = corridor_.size() - 1; from-- > 0;)
      for (std::size_t option = 0; option < left_[from].size(); ++option)
        left_[from][option] = leastLeft(from, option);
  }

  [[nodiscard]] Cost leastLeft(std::size_t from, std::size_t option) const {
    const Point here = corridor_[from].options[option].out.position();
    Cost least = Cost::most();
    for (std::size_t to = from + 1; to < corridor_.size() && to <= from + corridor_[from].reach; ++to) {
      for (std::size_t o = 0; o < corridor_[to].options.size(); ++o) {
        const Option& there = corridor_[to].options[o];
        const double way_m = distance(here, there.in.position());
        const Cost leg = way_m <= kSamePoint_m ? Cost() : corridor_[from].legs_on->cheapestLeg(way_m);
        least = std::min(least, leg + there.cost + left_[to][o]);
      }
      if (!corridor_[to].may_be_skipped) break;
    }
    return least;
  }

  void leave(std::uint32_t from, std::uint32_t option) {
    for (std::uint32_t to = from + 1; to < corridor_.size() && to <= from + corridor_[from].reach; ++to) {
      for (std::uint32_t o = 0; o < corridor_[to].options.size(); ++o) go(from, option, to, o);
      if (!corridor_[to].may_be_skipped) return;
    }
  }

  /// All ways from one option to another: of each the cheapest state it can begin with.
  void go(std::uint32_t from, std::uint32_t option, std::uint32_t to, std::uint32_t to_option) {
    const Option& a = corridor_[from].options[option];
    const Option& b = corridor_[to].options[to_option];
    const Legs& legs = *corridor_[from].legs_on;
    const double way_m = distance(a.out.position(), b.in.position());
    if (way_m <= kSamePoint_m) {
      if (a.out.position() == b.in.position())
        for (const std::uint32_t state : at_[from][option])
          arrive(state, to, to_option, kNone, states_[state].leaving, states_[state].cost, legs);
      return;
    }
    if (limit(to, to_option, legs.cheapestLeg(way_m)) <= leastOf(from, option)) return;
    const double direction = std::atan2(b.in.y - a.out.y, b.in.x - a.out.x);
    const double keep_m = std::min(a.keep_m, b.keep_m);
    const std::size_t count = legs.ways().size();
    free_.assign(count, -1);
    const bool turns_freely = turnsFreely(from, option, legs);
    for (std::uint32_t w = 0; w < count; ++w) {
      const Way& way = legs.ways()[w];
      const Stance stance{normalizedAngle(direction - way.angle_rad), way.mode};
      const Cost leg = legs.legCost(way, way_m);
      std::uint32_t parent = kNone;
      Cost cost = limit(to, to_option, leg);
      for (const std::uint32_t state : at_[from][option]) {
        const Cost turned = states_[state].cost + legs.changeCost(states_[state].leaving, stance);
        if (turned < cost) cost = turned, parent = state;
      }
      if (parent == kNone) continue;
      char& is_free = free_[legs.sameSweep(w)];
      if (is_free < 0)
        is_free = legs.isLegFree(way, a.out.position(), b.in.position(), stance.yaw, keep_m) ? 1 : 0;
      if (is_free == 0) continue;
      const Cost change = freeChange(states_[parent], a, stance, legs, turns_freely);
      if (change != legs.changeCost(states_[parent].leaving, stance)) {  // not the short way, or not at all
        cost = limit(to, to_option, leg);
        parent = kNone;
        for (const std::uint32_t state : at_[from][option]) {
          const Cost other = freeChange(states_[state], a, stance, legs, turns_freely);
          if (other == Cost::most() || states_[state].cost + other >= cost) continue;
          cost = states_[state].cost + other;
          parent = state;
        }
        if (parent == kNone) continue;
      }
      arrive(parent, to, to_option, w, stance, cost + leg, legs);
    }
  }

  /// Of changing from a state's stance to another, as far as that is free.
  [[nodiscard]] static Cost freeChange(State& state, const Option& at, const Stance& to, const Legs& legs,
                                       bool turns_freely) {
    if (turns_freely) return legs.changeCost(state.leaving, to);
    if (!state.has_room) {
      state.room = legs.roomAt(at.out.position(), state.leaving, at.keep_m);
      state.has_room = true;
    }
    return legs.freeChangeCost(at.out.position(), state.leaving, state.room, to, at.keep_m);
  }

  /// What a state may cost before a leg and still be of use after it: less than the bound, and no more above
  /// the cheapest there than any change of stance costs.
  [[nodiscard]] Cost limit(std::uint32_t station, std::uint32_t option, Cost leg) const {
    const Cost ahead = corridor_[station].options[option].cost + left_[station][option];
    const Cost most = std::min(bound_ > ahead ? bound_ - ahead : Cost(), leastAt(station, option));
    return most > leg ? most - leg : Cost();
  }

  [[nodiscard]] Cost leastOf(std::uint32_t station, std::uint32_t option) const {
    Cost least = Cost::most();
    for (const std::uint32_t state : at_[station][option]) least = std::min(least, states_[state].cost);
    return least;
  }

  [[nodiscard]] Cost leastAt(std::uint32_t station, std::uint32_t option) const {
    const Cost least = leastOf(station, option);
    if (least == Cost::most()) return least;
    const Option& here = corridor_[station].options[option];
    return here.is_stop ? least + corridor_[station].legs_on->dearestChange() : least;
  }

  void arrive(std::uint32_t parent, std::uint32_t station, std::uint32_t option, std::uint32_t way,
              const Stance& arriving, Cost cost, const Legs& legs) {
    const Option& here = corridor_[station].options[option];
    State state{parent, station, option, way, arriving, arriving, cost, false, {}};
    if (!here.is_stop) {
      const Stance needed{here.any_heading ? arriving.yaw : here.in.yaw, here.in_mode};
      const Cost change = legs.freeChangeCost(here.in.position(), arriving, needed, here.keep_m);
      if (change == Cost::most()) return;
      state.leaving = {here.any_heading ? arriving.yaw : here.out.yaw, here.out_mode};
      state.cost = cost + change + here.cost;
    }
    std::vector<std::uint32_t>& states = at_[station][option];
    if (!here.is_stop && !states.empty()) {  // all leave in the same stance: the cheapest is enough
      if (states_[states[0]].cost > state.cost) states_[states[0]] = state;
      return;
    }
    const auto reaches_as_cheaply = [&](std::uint32_t other) {
      return states_[other].cost + legs.changeCost(states_[other].leaving, arriving) <= state.cost;
    };
    if (std::any_of(states.begin(), states.end(), reaches_as_cheaply) && turnsFreely(station, option, legs))
      return;
    states.push_back(static_cast<std::uint32_t>(states_.size()));
    states_.push_back(state);
  }

  /// Whether any stance can be changed into any other there: then the cheaper state serves for both.
  bool turnsFreely(std::uint32_t station, std::uint32_t option, const Legs& legs) {
    char& known = turns_freely_[station][option];
    const Option& here = corridor_[station].options[option];
    if (known < 0) known = legs.turnsFreely(here.out.position(), here.keep_m) ? 1 : 0;
    return known == 1;
  }

  [[nodiscard]] Passage passageTo(std::uint32_t last) const {
    Passage passage{{}, states_[last].cost};
    for (std::uint32_t s = last; s != kNone; s = states_[s].parent) {
      const State& state = states_[s];
      const Legs* legs = state.parent == kNone ? nullptr : corridor_[states_[state.parent].station].legs_on;
      passage.steps.push_back({corridor_[state.station].options[state.option], legs,
                               state.way == kNone ? std::nullopt : std::optional<std::size_t>(state.way),
                               state.arriving, state.leaving});
    }
    std::reverse(passage.steps.begin(), passage.steps.end());
    return passage;
  }

  const Corridor& corridor_;
  Cost bound_;
  std::vector<State> states_;
  std::vector<std::vector<std::vector<std::uint32_t>>> at_;  // states by station and option
  std::vector<std::vector<Cost>> left_;                      // by station and option
  std::vector<std::vector<char>> turns_freely_;              // by station and option; -1: not known
  std::vector<char> free_;                                   // of the leg at hand, by way; -1: not known
};

}  // namespace

std::optional<Passage> cheapestThrough(const Corridor& corridor, Cost bound, Interrupt& interrupt) {
  return Passing(corridor, bound).cheapest(interrupt);
}

}  // namespace underway
