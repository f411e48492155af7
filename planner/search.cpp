#include "planner/search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "planner/guide.hpp"
#include "planner/rivals.hpp"
#include "planner/state_table.hpp"

namespace underway {
namespace {

using LinkId = Roadmap::LinkId;
using PlaceId = Roadmap::PlaceId;
using StateId = StateTable::Id;

struct Open {
  Cost bound;  // cost so far plus the least that is left
  StateId state;
  bool operator<(const Open& other) const {  // the cheapest first; of equal ones that with the smaller number
    return bound > other.bound || (bound == other.bound && state > other.state);
  }
};

class Search {
 public:
  Search(const Draft& graph, const Stances& stances, const Robot& robot, LinkChecks& checks,
         const Target& target, Cost below, Interrupt& interrupt)
      : graph_(graph),
        stances_(stances),
        robot_(robot),
        checks_(checks),
        target_(target),
        interrupt_(interrupt),
        guide_(graph, stances, target.start, placesOf(target), interrupt),
        stride_(static_cast<StateId>(stances.mostWays())),
        states_(tableOfThisThread()),
        end_(1 + graph.linkCount() * stride_),
        best_(below),
        rivals_(graph.placeCount(), states_),
        is_margin_enough_(stances.atLeast() <= robot.margin_m),
        nearest_m_(toGoal(graph.place(target.start).at)),
        nearest_(0) {}

  std::optional<Passage> cheapest() {
    states_.begin(end_ + static_cast<StateId>(target_.goals.size()));
    if (best_ != Cost::most()) guide_.workOut(best_);  // all of it may be asked for
    const Cost least = guide_.from(target_.start);
    if (least < best_) arrive(0, Roadmap::kNone, Cost(), least);
    while (!open_.empty() && !interrupt_.isDue()) {
      const auto [bound, here] = open_.front();
      std::pop_heap(open_.begin(), open_.end());
      open_.pop_back();
      if (states_[here].is_settled || states_[here].is_surpassed || isDearer(here, bound)) continue;
      states_[here].is_settled = 1;
      if (here >= end_) return passageTo(here);
      if (!hasCompeted(here) && (!isFree(here) || isSurpassed(here))) continue;
      notice(here);
      leave(here);
    }
    return std::nullopt;
  }

  /// The pose nearest to the goal that was reached.
  [[nodiscard]] Pose nearest() const {
    const Point at = graph_.place(placeOf(nearest_)).at;
    return {at.x, at.y, stanceOf(nearest_).yaw};
  }

 private:
  static std::vector<PlaceId> placesOf(const Target& target) {
    std::vector<PlaceId> places;
    for (const Target::Goal& goal : target.goals) places.push_back(goal.place);
    return places;
  }

  static StateTable& tableOfThisThread() {
    thread_local StateTable table;
    return table;
  }

  [[nodiscard]] LinkId linkOf(StateId state) const { return (state - 1) / stride_; }
  [[nodiscard]] std::size_t wayOf(StateId state) const { return (state - 1) % stride_; }
  [[nodiscard]] StateId stateOf(LinkId link, std::size_t way) const {
    return 1 + link * stride_ + static_cast<StateId>(way);
  }
  [[nodiscard]] PlaceId placeOf(StateId state) const {
    return state == 0 ? target_.start : graph_.link(linkOf(state)).to;
  }
  [[nodiscard]] const Legs& legsAt(PlaceId place) const {
    return stances_.ofGroup(graph_.place(place).group);
  }

  [[nodiscard]] Stance stanceOf(StateId state) const {
    if (state == 0) return target_.start_stance;
    const Roadmap::Link& link = graph_.link(linkOf(state));
    if (link.crossing == Roadmap::kNone) return legsAt(link.to).stanceOn(link.direction_rad, wayOf(state));
    const Crossing& crossing = graph_.crossing(link);
    return {crossing.exit().yaw, crossing.exitMode()};
  }

  [[nodiscard]] bool isSureToBeFree(LinkId link) const { return graph_.isChecked(link) && is_margin_enough_; }

  [[nodiscard]] bool isFree(StateId state) {
    if (state == 0) return true;
    const LinkId link = linkOf(state);
    if (isSureToBeFree(link)) return true;
    return checks_.isFree(link, wayOf(state), legsAt(graph_.link(link).from));
  }

  [[nodiscard]] bool turnsFreely(PlaceId place) const {
    return graph_.place(place).turns_freely && is_margin_enough_;
  }

  /// How far the nearest goal is away.
  [[nodiscard]] double toGoal(Point at) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (const Target::Goal& goal : target_.goals)
      least_m = std::min(least_m, distance(at, graph_.place(goal.place).at));
    return least_m;
  }

  void notice(StateId state) {
    const double away_m = toGoal(graph_.place(placeOf(state)).at);
    if (away_m < nearest_m_) nearest_m_ = away_m, nearest_ = state;
  }

  /// Whether arriving at a state so is cheaper than before, and may lead to a cheaper end.
  [[nodiscard]] bool isWorthMore(StateId state, Cost cost, Cost left) {
    const SearchState& known = states_[state];
    return known.is_settled == 0 && cost < known.cost && cost + left < best_;
  }

  void arrive(StateId state, StateId parent, Cost cost, Cost left) {
    SearchState& at = states_[state];
    at.cost = cost;
    at.parent = parent;
    at.is_surpassed = 0;
    open({cost + left, state});
  }

  void open(const Open& next) {
    open_.push_back(next);
    std::push_heap(open_.begin(), open_.end());
  }

  /// Whether a state that comes up leads to an end at a higher cost than was known when it was arrived at;
  /// then it waits for its turn.
  [[nodiscard]] bool isDearer(StateId here, Cost bound) {
    if (here >= end_) return false;
    const Cost cost = states_[here].cost;
    const Cost next = open_.empty() ? best_ : std::min(best_, open_.front().bound);
    const Cost now = cost + guide_.from(placeOf(here), next > cost ? next - cost : Cost());
    if (now <= bound) return false;
    if (now < best_) open({now, here});
    return true;
  }

  /// Where all changes are free, and their cost is all that matters.
  [[nodiscard]] bool changeFreely(PlaceId place) const {
    return turnsFreely(place) && legsAt(place).areAlike();
  }

  /// Whether a state has competed with those at its place when it was arrived at: it is sure to be free.
  [[nodiscard]] bool hasCompeted(StateId state) const {
    return state != 0 && isSureToBeFree(linkOf(state)) && changeFreely(placeOf(state));
  }

  /// Whether another state at the same place surpasses one that has come up; else it is among them.
  bool isSurpassed(StateId here) {
    const PlaceId place = placeOf(here);
    const Stance stance = stanceOf(here);
    const Legs& legs = legsAt(place);
    // Where switches need room, what can be reached by way of this stance may not be in one change.
    if (!legs.areAlike()) return false;
    const Cost cost = states_[here].cost;
    if (turnsFreely(place)) return !rivals_.compete(place, legs, here, stance, cost);
    const bool is_surpassed = rivals_.anyAt(place, [&](StateId other, const Stance& from, Cost its) {
      return its + legs.changeCost(from, stance) <= cost &&
             its + freeTightChange(other, place, legs, from, stance) <= cost;
    });
    if (!is_surpassed) rivals_.add(place, here, stance, cost);
    return is_surpassed;
  }

  /// A state that is left: what all ways on have in common.
  struct Here {
    StateId state;
    PlaceId place;
    Stance stance;
    Cost cost;
    const Legs& legs;
    bool turns_freely;
  };

  void leave(StateId state) {
    const PlaceId place = placeOf(state);
    const Here here{state, place, stanceOf(state), states_[state].cost, legsAt(place), turnsFreely(place)};
    graph_.forEachOpenLinkFrom(place, [&](LinkId id, const Roadmap::Link& link, Roadmap::Ways ways) {
      if (link.crossing != Roadmap::kNone)
        cross(here, id, link);
      else
        walk(here, id, link, ways);
    });
    for (std::size_t i = 0; i < target_.goals.size(); ++i) {
      const Target::Goal& goal = target_.goals[i];
      if (goal.place != place) continue;
      const Stance to{goal.any_heading ? here.stance.yaw : goal.stance.yaw, goal.stance.mode};
      end(end_ + static_cast<StateId>(i), here, here.cost + freeChange(here, to));
    }
  }

  /// At a goal: nothing that costs as much can lead to a better one.
  void end(StateId goal, const Here& here, Cost cost) {
    if (isWorthMore(goal, cost, Cost())) arrive(goal, here.state, cost, Cost());
    best_ = std::min(best_, cost);
  }

  void cross(const Here& here, LinkId id, const Roadmap::Link& link) {
    const StateId state = stateOf(id, 0);
    const Crossing& crossing = graph_.crossing(link);
    const Cost crossed = here.cost + crossing.cost(stances_.policy());
    const Cost left = guide_.atLeastFrom(link.to);
    if (!isWorthMore(state, crossed, left)) return;
    const Cost cost = crossed + freeChange(here, {crossing.entry().yaw, crossing.entryMode()});
    if (!isWorthMore(state, cost, left)) return;
    const Stance exit{crossing.exit().yaw, crossing.exitMode()};
    if (isSureToBeFree(id) && changeFreely(link.to) &&
        !rivals_.compete(link.to, legsAt(link.to), state, exit, cost))
      return;
    arrive(state, here.state, cost, left);
  }

  /// By all ways of a link, unless turning at its end instead of here costs no more: what turns into this
  /// stance there turns into all that the ways lead to.
  void walk(const Here& here, LinkId id, const Roadmap::Link& link, Roadmap::Ways ways) {
    const Legs& legs = here.legs;
    const bool changes_freely = legs.areAlike() && turnsFreely(link.to);
    const Cost least = here.cost + legs.cheapestLeg(ways, link.length_m);
    if (changes_freely && rivals_.surpass(link.to, legs, here.stance, least)) return;
    const Cost left = guide_.atLeastFrom(link.to);
    if (least + left >= best_) return;
    const bool competes = changes_freely && isSureToBeFree(id);
    for (Roadmap::Ways rest = ways; rest != 0; rest &= rest - 1) {
      const auto way = static_cast<std::size_t>(std::countr_zero(rest));
      const StateId state = stateOf(id, way);
      const Stance to = legs.stanceOn(link.direction_rad, way);
      const Cost walked = here.cost + legs.legCost(legs.ways()[way], link.length_m);
      Cost cost = walked + legs.changeCost(here.stance, to);
      if (!isWorthMore(state, cost, left)) continue;
      if (!here.turns_freely) {
        cost = walked + freeChange(here, to);
        if (!isWorthMore(state, cost, left)) continue;
      }
      if (!competes || rivals_.compete(link.to, legs, state, to, cost)) arrive(state, here.state, cost, left);
    }
  }

  /// Of a change from a state's stance to another, Cost::most() if it is not free.
  [[nodiscard]] Cost freeChange(const Here& from, const Stance& to) {
    if (from.turns_freely) return from.legs.changeCost(from.stance, to);
    return freeTightChange(from.state, from.place, from.legs, from.stance, to);
  }

  [[nodiscard]] Cost freeTightChange(StateId here, PlaceId place, const Legs& legs, const Stance& from,
                                     const Stance& to) {
    const Roadmap::Place& at = graph_.place(place);
    SearchState& state = states_[here];
    if (state.room == Roadmap::kNone) {
      state.room = static_cast<std::uint32_t>(rooms_.size());
      rooms_.push_back(checks_.roomOf(here, at, from, legs));
    }
    return legs.freeChangeCost(at.at, from, rooms_[state.room], to, at.keep_m);
  }

  [[nodiscard]] Option optionAt(PlaceId place) const {
    const Roadmap::Place& here = graph_.place(place);
    return Option::stop(here.at, here.keep_m);
  }

  [[nodiscard]] Option optionOf(const Crossing& crossing, double keep_m) const {
    return {crossing.entry(),
            crossing.exit(),
            crossing.entryMode(),
            crossing.exitMode(),
            false,
            false,
            keep_m,
            crossing.motions,
            crossing.cost(stances_.policy())};
  }

  /// The steps along the states that lead to an end: a leg that a crossing follows leads straight to its
  /// entry.
  [[nodiscard]] Passage passageTo(StateId end) {
    std::vector<StateId> states;
    for (StateId state = states_[end].parent; state != 0; state = states_[state].parent)
      states.push_back(state);
    std::reverse(states.begin(), states.end());
    Passage passage{{}, states_[end].cost, end - end_};
    const Roadmap::Place& start = graph_.place(target_.start);
    const Pose from{start.at.x, start.at.y, target_.start_stance.yaw};
    passage.steps.push_back({{from,
                              from,
                              target_.start_stance.mode,
                              target_.start_stance.mode,
                              false,
                              false,
                              start.keep_m,
                              {},
                              {}},
                             nullptr,
                             std::nullopt,
                             target_.start_stance,
                             target_.start_stance});
    Stance here = target_.start_stance;
    std::optional<std::size_t> way;
    const Legs* legs = nullptr;
    const auto step_to = [&](Option option) {
      const Stance leaving = option.is_stop       ? here
                             : option.any_heading ? Stance{here.yaw, option.out_mode}
                                                  : Stance{option.out.yaw, option.out_mode};
      passage.steps.push_back({std::move(option), legs, way, here, leaving});
      here = leaving;
      way.reset();
    };
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Roadmap::Link& link = graph_.link(linkOf(states[i]));
      legs = &legsAt(link.from);
      if (link.crossing != Roadmap::kNone) {
        step_to(optionOf(graph_.crossing(link), std::min(graph_.place(link.from).keep_m, robot_.margin_m)));
        continue;
      }
      way = wayOf(states[i]);
      here = stanceOf(states[i]);
      const bool is_crossing_next =
          i + 1 < states.size() && graph_.link(linkOf(states[i + 1])).crossing != Roadmap::kNone;
      const bool is_last = i + 1 == states.size();
      if (!is_crossing_next && !is_last) step_to(optionAt(link.to));
    }
    const Target::Goal& goal = target_.goals[passage.goal];
    const Roadmap::Place& at = graph_.place(goal.place);
    const Pose to{at.at.x, at.at.y, goal.stance.yaw};
    if (legs == nullptr || !way) legs = &legsAt(goal.place);
    step_to({to, to, goal.stance.mode, goal.stance.mode, false, goal.any_heading, at.keep_m, {}, {}});
    return passage;
  }

  const Draft& graph_;
  const Stances& stances_;
  const Robot& robot_;
  LinkChecks& checks_;
  const Target& target_;
  Interrupt& interrupt_;
  Guide guide_;
  StateId stride_;
  StateTable& states_;  // the start, each way of each link, an end for each goal
  StateId end_;         // the first one
  Cost best_;           // at any of them
  Rivals rivals_;
  std::vector<TurningRoom> rooms_;
  std::vector<Open> open_;  // a heap
  bool is_margin_enough_;
  double nearest_m_;
  StateId nearest_;
};

}  // namespace

std::optional<Passage> search(const Draft& graph, const Stances& stances, const Robot& robot,
                              LinkChecks& checks, const Target& target, Interrupt& interrupt, Pose* nearest,
                              Cost below) {
  Search search(graph, stances, robot, checks, target, below, interrupt);
  auto passage = search.cheapest();
  if (!passage && nearest) *nearest = search.nearest();
  return passage;
}

}  // namespace underway
