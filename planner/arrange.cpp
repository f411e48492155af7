#include "planner/arrange.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace underway {
namespace {

using LinkId = Roadmap::LinkId;
using PlaceId = Roadmap::PlaceId;

/// The forest of joined places (union-find); its own number at a root.
class Forest {
 public:
  explicit Forest(std::size_t places) : parents_(places) {
    std::iota(parents_.begin(), parents_.end(), PlaceId{0});
  }

  void join(PlaceId a, PlaceId b) { parents_[rootOf(a)] = rootOf(b); }
  PlaceId rootOf(PlaceId place) {
    while (parents_[place] != place)
      place = parents_[place] = parents_[parents_[place]];  // halves the way for the next time
    return place;
  }

 private:
  std::vector<PlaceId> parents_;
};

void indexCrossings(Roadmap& roadmap) {
  roadmap.first_in.assign(roadmap.places.size() + 1, 0);
  for (const Roadmap::Link& link : roadmap.links)
    if (link.crossing != Roadmap::kNone) ++roadmap.first_in[link.to + 1];
  std::partial_sum(roadmap.first_in.begin(), roadmap.first_in.end(), roadmap.first_in.begin());
  roadmap.crossings_in.resize(roadmap.first_in.back());
  std::vector<std::uint32_t> next(roadmap.first_in.begin(), roadmap.first_in.end() - 1);
  for (LinkId link = 0; link < roadmap.links.size(); ++link)
    if (roadmap.links[link].crossing != Roadmap::kNone)
      roadmap.crossings_in[next[roadmap.links[link].to]++] = link;
}

void indexPlaces(Roadmap& roadmap) {
  constexpr std::uint32_t kSmallPart = 12;
  Forest forest(roadmap.places.size());
  for (LinkId id = 0; id < roadmap.links.size(); ++id)
    if (roadmap.ways[id] != 0) forest.join(roadmap.links[id].from, roadmap.links[id].to);
  std::vector<std::uint32_t> count(roadmap.places.size(), 0);
  for (PlaceId place = 0; place < roadmap.places.size(); ++place) ++count[forest.rootOf(place)];
  std::vector<PlaceIndex::Entry> all;
  std::vector<PlaceIndex::Entry> in_large_parts;
  for (PlaceId id = 0; id < roadmap.places.size(); ++id) {
    all.push_back({roadmap.places[id].at, roadmap.places[id].group, id});
    if (count[forest.rootOf(id)] >= kSmallPart) in_large_parts.push_back(all.back());
  }
  roadmap.index = PlaceIndex(std::move(all));
  roadmap.main_index = PlaceIndex(std::move(in_large_parts));
}

}  // namespace

void arrange(Roadmap& roadmap, std::span<const Legs> legs) {
  for (Roadmap::Place& place : roadmap.places)
    place.turns_freely = legs[place.group].turnsFreely(place.at, place.keep_m);
  indexCrossings(roadmap);
  indexPlaces(roadmap);
  roadmap.count();
}

}  // namespace underway
