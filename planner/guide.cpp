#include "planner/guide.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

using PlaceId = Roadmap::PlaceId;

Guide::Guide(const Draft& graph, const Stances& stances, PlaceId start, std::span<const PlaceId> goals,
             Interrupt& interrupt)
    : graph_(graph),
      stances_(stances),
      interrupt_(interrupt),
      start_(graph.place(start).at),
      us_per_m_(stances.highestSpeed() > 0.0 ? 1e6 / stances.highestSpeed() : 0.0),  // 0: it only turns
      least_(graph.placeCount(), Cost::most()),
      is_settled_(graph.placeCount(), 0) {
  for (const PlaceId goal : goals) reach(goal, Cost());
}

Cost Guide::from(PlaceId place, Cost enough) {
  constexpr int kAtOnce = 16;  // places, lest the caller comes again and again
  for (int more = kAtOnce; is_settled_[place] == 0 && !open_.empty(); --more) {
    if (more <= 0 && atLeastFrom(place) > enough) break;
    if (interrupt_.isDue()) return Cost::most();
    settleNext();
  }
  return atLeastFrom(place);
}

void Guide::workOut(Cost below) {
  while (!open_.empty() && open_.front().bound < below && !interrupt_.isDue()) settleNext();
}

Cost Guide::atLeastFrom(PlaceId place) const {
  if (is_settled_[place] != 0) return least_[place];
  if (open_.empty()) return Cost::most();
  const Cost all = open_.front().bound;  // of a way by any place that is not settled
  const Cost before = wayTo(place);
  return all > before ? all - before : Cost();
}

void Guide::reach(PlaceId place, Cost cost) {
  if (is_settled_[place] || cost >= least_[place]) return;
  least_[place] = cost;
  open_.push_back({cost + wayTo(place), place});
  std::push_heap(open_.begin(), open_.end());
}

void Guide::settleNext() {
  const PlaceId here = open_.front().place;
  std::pop_heap(open_.begin(), open_.end());
  open_.pop_back();
  if (is_settled_[here]) return;
  is_settled_[here] = 1;
  const Cost cost = least_[here];
  const Legs& legs = stances_.ofGroup(graph_.place(here).group);  // legs join places of one group
  graph_.forEachLinkFrom(here, [&](Roadmap::LinkId id) {
    const Roadmap::Link& link = graph_.link(id);
    if (link.twin == Roadmap::kNone || is_settled_[link.to]) return;
    const Roadmap::Ways ways = graph_.ways(link.twin);
    if (ways == 0) return;
    const Cost sum = cost + legs.cheapestLeg(ways, link.length_m);
    if (sum < least_[link.to]) reach(link.to, sum);
  });
  graph_.forEachCrossingTo(here, [&](Roadmap::LinkId id) {
    if (graph_.ways(id) != 0)
      reach(graph_.link(id).from, cost + graph_.crossing(graph_.link(id)).cost(stances_.policy()));
  });
}

}  // namespace underway
