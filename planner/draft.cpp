#include "planner/draft.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/arrange.hpp"

namespace underway {

using LinkId = Roadmap::LinkId;
using PlaceId = Roadmap::PlaceId;

Draft::Draft(const Roadmap* base)
    : base_(base),
      first_place_(base ? static_cast<PlaceId>(base->places.size()) : 0),
      first_link_(base ? static_cast<LinkId>(base->links.size()) : 0),
      first_crossing_(base ? static_cast<std::uint32_t>(base->crossings.size()) : 0),
      out_(first_place_, Roadmap::kNone),
      crossings_in_(first_place_, Roadmap::kNone),
      last_out_(first_place_, Roadmap::kNone) {}

PlaceId Draft::addPlace(GroupId group, Point at, double keep_m) {
  parents_.push_back(placeCount());
  places_.push_back({at, group, false, keep_m, 0, 0});
  out_.push_back(Roadmap::kNone);
  crossings_in_.push_back(Roadmap::kNone);
  last_out_.push_back(Roadmap::kNone);
  return placeCount() - 1;
}

void Draft::keepLess(PlaceId place, double keep_m) {
  double& keep = places_[place - first_place_].keep_m;
  keep = std::min(keep, keep_m);
}

LinkId Draft::addLink(const Roadmap::Link& link, Ways ways, bool is_checked) {
  const LinkId id = linkCount();
  links_.push_back(link);
  ways_.push_back(ways);
  is_checked_.push_back(is_checked ? 1 : 0);
  next_out_.push_back(Roadmap::kNone);
  next_in_.push_back(Roadmap::kNone);
  LinkId& last = last_out_[link.from];
  (last == Roadmap::kNone ? out_[link.from] : next_out_[last - first_link_]) = id;
  last = id;
  if (link.crossing != Roadmap::kNone) {
    next_in_.back() = crossings_in_[link.to];
    crossings_in_[link.to] = id;
  }
  if (ways != 0) join(link.from, link.to);
  return id;
}

void Draft::addLegs(PlaceId a, PlaceId b, const WaysOf& there, const WaysOf& back, bool are_checked) {
  const Point from = place(a).at;
  const Point to = place(b).at;
  const double way_m = distance(from, to);
  const LinkId first = linkCount();
  addLink({a, b, first + 1, Roadmap::kNone, std::atan2(to.y - from.y, to.x - from.x), way_m, there.tried},
          there.free, are_checked);
  addLink({b, a, first, Roadmap::kNone, std::atan2(from.y - to.y, from.x - to.x), way_m, back.tried},
          back.free, are_checked);
}

void Draft::addCrossing(PlaceId from, PlaceId to, Crossing crossing) {
  const auto index = first_crossing_ + static_cast<std::uint32_t>(crossings_.size());
  crossings_.push_back(std::move(crossing));
  addLink({from, to, Roadmap::kNone, index, 0.0, 0.0, 1}, 1, true);
}

void Draft::join(PlaceId a, PlaceId b) {
  if (a < first_place_ || b < first_place_) return;  // the base's places are joined as they are
  parents_[rootOf(a) - first_place_] = rootOf(b);
}

PlaceId Draft::rootOf(PlaceId place) {
  const auto parent = [&](PlaceId of) -> PlaceId& { return parents_[of - first_place_]; };
  while (parent(place) != place)
    place = parent(place) = parent(parent(place));  // halves the way for the next time
  return place;
}

std::optional<Roadmap> Draft::freeze(std::span<const underway::Legs> legs, Interrupt& interrupt) const {
  Roadmap roadmap;
  roadmap.places = places_;
  roadmap.crossings = crossings_;
  roadmap.links.reserve(links_.size());
  std::vector<LinkId> renumbered(links_.size());
  for (PlaceId place = 0; place < places_.size(); ++place) {
    if (interrupt.isDue()) return std::nullopt;
    Roadmap::Place& here = roadmap.places[place];
    here.first_link = static_cast<LinkId>(roadmap.links.size());
    forEachLinkFrom(place, [&](LinkId link) {
      renumbered[link] = static_cast<LinkId>(roadmap.links.size());
      roadmap.links.push_back(links_[link]);
      roadmap.ways.push_back(ways_[link]);
    });
    here.end_link = static_cast<LinkId>(roadmap.links.size());
  }
  for (Roadmap::Link& link : roadmap.links)
    if (link.twin != Roadmap::kNone) link.twin = renumbered[link.twin];
  arrange(roadmap, legs);
  return roadmap;
}

Draft Draft::thawed(const Roadmap& roadmap) {
  Draft draft;
  for (const Roadmap::Place& place : roadmap.places) draft.addPlace(place.group, place.at, place.keep_m);
  draft.crossings_ = roadmap.crossings;
  // Links get the numbers they have: twins find each other, and each place's stay in their order.
  for (LinkId id = 0; id < roadmap.links.size(); ++id)
    draft.addLink(roadmap.links[id], roadmap.ways[id], true);
  return draft;
}

}  // namespace underway
