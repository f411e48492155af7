#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/interrupt.hpp"
#include "planner/legs.hpp"
#include "planner/roadmap.hpp"

namespace underway {

/// A roadmap under construction. A draft may lie over a frozen roadmap, for one query: ids below the base's
/// counts are the base's own, and its places can be linked to like the draft's.
class Draft {
 public:
  using PlaceId = Roadmap::PlaceId;
  using LinkId = Roadmap::LinkId;
  using Ways = Roadmap::Ways;

  /// The base must outlive it.
  explicit Draft(const Roadmap* base = nullptr);

  PlaceId addPlace(GroupId group, Point at, double keep_m);
  /// Lowers what is kept at a place: where a goal is, a start may be too.
  void keepLess(PlaceId place, double keep_m);
  struct WaysOf {
    Ways tried = 0;
    Ways free = 0;
  };
  /// Links both ways between two places at different positions. `are_checked`: `free` is known; else it is to
  /// be found out by who wants to use them.
  void addLegs(PlaceId a, PlaceId b, const WaysOf& there, const WaysOf& back, bool are_checked);
  void addCrossing(PlaceId from, PlaceId to, Crossing crossing);

  [[nodiscard]] const Roadmap* base() const { return base_; }
  [[nodiscard]] PlaceId placeCount() const { return first_place_ + static_cast<PlaceId>(places_.size()); }
  [[nodiscard]] LinkId linkCount() const { return first_link_ + static_cast<LinkId>(links_.size()); }
  [[nodiscard]] const Roadmap::Place& place(PlaceId id) const {
    return id < first_place_ ? base_->places[id] : places_[id - first_place_];
  }
  [[nodiscard]] const Roadmap::Link& link(LinkId id) const {
    return id < first_link_ ? base_->links[id] : links_[id - first_link_];
  }
  /// The ways that are free, or may be.
  [[nodiscard]] Ways ways(LinkId id) const {
    return id < first_link_ ? base_->ways[id] : ways_[id - first_link_];
  }
  [[nodiscard]] bool isChecked(LinkId id) const { return id < first_link_ || is_checked_[id - first_link_]; }
  [[nodiscard]] const Crossing& crossing(const Roadmap::Link& link) const {
    return link.crossing < first_crossing_ ? base_->crossings[link.crossing]
                                           : crossings_[link.crossing - first_crossing_];
  }
  /// Calls visit(id) for all links that leave a place, and for all crossings that lead to it.
  template <class Visit>
  void forEachLinkFrom(PlaceId id, const Visit& visit) const {
    if (id < first_place_)
      for (LinkId link = base_->places[id].first_link; link < base_->places[id].end_link; ++link) visit(link);
    for (LinkId link = firstOf(out_, id); link != Roadmap::kNone; link = next_out_[link - first_link_])
      visit(link);
  }
  /// Calls visit(id, link, ways) for those that leave it and are free by some way, or may be.
  template <class Visit>
  void forEachOpenLinkFrom(PlaceId id, const Visit& visit) const {
    forEachLinkFrom(id, [&](LinkId link) {
      if (const Ways open = ways(link); open != 0) visit(link, this->link(link), open);
    });
  }
  template <class Visit>
  void forEachCrossingTo(PlaceId id, const Visit& visit) const {
    if (id < first_place_)
      for (std::uint32_t i = base_->first_in[id]; i < base_->first_in[id + 1]; ++i)
        visit(base_->crossings_in[i]);
    for (LinkId link = firstOf(crossings_in_, id); link != Roadmap::kNone;
         link = next_in_[link - first_link_])
      visit(link);
  }
  /// Whether links lead from one place to the other, taken both ways. Of the draft's own places.
  [[nodiscard]] bool areJoined(PlaceId a, PlaceId b) { return rootOf(a) == rootOf(b); }

  /// A draft that goes on from a frozen roadmap: freezing it at once gives the same roadmap, bit for bit, and
  /// so does adding to it what was added to the draft that the roadmap came from.
  [[nodiscard]] static Draft thawed(const Roadmap& roadmap);
  /// The roadmap, for a draft without a base whose links are all checked; empty when interrupted. `legs`: by
  /// group.
  [[nodiscard]] std::optional<Roadmap> freeze(std::span<const underway::Legs> legs,
                                              Interrupt& interrupt) const;

 private:
  /// The first of a place's own links in a list; lists are chained through next_out_ and next_in_.
  using Heads = std::vector<LinkId>;
  [[nodiscard]] LinkId firstOf(const Heads& heads, PlaceId place) const {
    return place < heads.size() ? heads[place] : Roadmap::kNone;
  }
  LinkId addLink(const Roadmap::Link& link, Ways ways, bool is_checked);
  void join(PlaceId a, PlaceId b);
  [[nodiscard]] PlaceId rootOf(PlaceId place);

  const Roadmap* base_;
  PlaceId first_place_;
  LinkId first_link_;
  std::uint32_t first_crossing_;
  std::vector<Roadmap::Place> places_;
  std::vector<PlaceId> parents_;  // in the forest of joined places (union-find); its own number at a root
  std::vector<Roadmap::Link> links_;
  std::vector<Ways> ways_;
  std::vector<char> is_checked_;
  std::vector<Crossing> crossings_;
  Heads out_;
  Heads crossings_in_;
  std::vector<LinkId> last_out_;  // of each place's list, so that links stay in the order they came
  std::vector<LinkId> next_out_;
  std::vector<LinkId> next_in_;
};

}  // namespace underway
