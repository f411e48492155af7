#include "planner/repair.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "planner/sites.hpp"

namespace underway {
namespace {

using LinkId = Roadmap::LinkId;
using PlaceId = Roadmap::PlaceId;

double reachOfBody(const BodyBox& body) {
  return std::hypot(std::max(-body.x.min, body.x.max), std::max(-body.y.min, body.y.max));
}

/// No part of the robot, in any mode or switch, is further from its frame's origin [m].
double reachOfRobot(const Robot& robot) {
  double reach = 0.0;
  for (const Mode& mode : robot.modes) reach = std::max(reach, reachOfBody(mode.body_m));
  for (const Switch& change : robot.switches) reach = std::max(reach, reachOfBody(change.body_m));
  return reach + 2.0 * robot.margin_m + 1e-6;
}

Region regionOf(const OrientedBox& box) {
  const auto vertices = corners(box);
  Region region{vertices[0].x, vertices[0].y, vertices[0].x, vertices[0].y};
  for (const Vec3& vertex : vertices) region = region.joint({vertex.x, vertex.y, vertex.x, vertex.y});
  return region;
}

Region regionOf(const Roadmap& roadmap, const Roadmap::Link& link, const Robot& robot) {
  double drift = 0.0;
  for (const Mode& mode : robot.modes) drift = std::max(drift, mode.drift_m_per_m);
  if (link.crossing == Roadmap::kNone)
    return Region::between(roadmap.places[link.from].at, roadmap.places[link.to].at).grown(drift * link.length_m);
  const Route& motions = roadmap.crossings[link.crossing].motions;
  Region region = Region::between(motions[0].from.position(), motions[0].to.position());
  double way_m = 0.0;
  for (const Motion& motion : motions) {
    region = region.joint(Region::between(motion.from.position(), motion.to.position()));
    way_m += length(motion);
  }
  return region.grown(drift * way_m);
}

/// Looks at links and places again, in a copy of a roadmap.
class Recheck {
 public:
  Recheck(const Roadmap& before, const Stances& stances, const Checker& checker, Repair& repair)
      : roadmap_(std::make_shared<Roadmap>(before)), stances_(stances), checker_(checker), repair_(repair) {}

  void place(PlaceId id) {
    Roadmap::Place& place = roadmap_->places[id];
    place.turns_freely = stances_.ofGroup(place.group).turnsFreely(place.at, place.keep_m);
  }

  /// A link and its twin.
  void link(LinkId id) {
    const Roadmap::Link& link = roadmap_->links[id];
    const Roadmap::Place& from = roadmap_->places[link.from];
    const Roadmap::Place& to = roadmap_->places[link.to];
    ++repair_.checked;
    if (link.crossing != Roadmap::kNone) {
      const Route& motions = roadmap_->crossings[link.crossing].motions;
      set(id, std::all_of(motions.begin(), motions.end(), [&](const Motion& m) { return checker_.isFree(m); }) ? 1 : 0);
      return;
    }
    const Legs& legs = stances_.ofGroup(from.group);
    const double keep_m = std::min(from.keep_m, to.keep_m);
    const Roadmap::Ways there = freeWays(legs, from.at, to.at, keep_m, nullptr);
    set(id, there);
    set(link.twin, freeWays(legs, to.at, from.at, keep_m, &there));
  }

  std::shared_ptr<const Roadmap> result() {
    roadmap_->count();
    return std::move(roadmap_);
  }

 private:
  void set(LinkId id, Roadmap::Ways free) {
    Roadmap::Ways& ways = roadmap_->ways[id];
    repair_.closed += static_cast<std::uint64_t>(std::popcount(ways & ~free));
    repair_.opened += static_cast<std::uint64_t>(std::popcount(free & ~ways));
    ways = free;
  }

  std::shared_ptr<Roadmap> roadmap_;
  const Stances& stances_;
  const Checker& checker_;
  Repair& repair_;
};

/// Whether a link stands for itself and its twin.
bool isFirstOfTwo(const Roadmap& roadmap, LinkId id) {
  return roadmap.links[id].twin == Roadmap::kNone || id < roadmap.links[id].twin;
}

}  // namespace

LinkIndex::LinkIndex(const Roadmap& roadmap, const Robot& robot)
    : places_(static_cast<std::uint32_t>(roadmap.places.size())) {
  const double reach = reachOfRobot(robot);
  std::vector<Region> regions;
  for (const Roadmap::Place& place : roadmap.places)
    regions.push_back(Region::between(place.at, place.at).grown(reach));
  for (LinkId id = 0; id < roadmap.links.size(); ++id) {
    if (!isFirstOfTwo(roadmap, id)) continue;
    links_.push_back(id);
    regions.push_back(regionOf(roadmap, roadmap.links[id], robot).grown(reach));
  }
  covered_ = RegionGrid(std::move(regions));
}

std::shared_ptr<const Roadmap> repaired(const Roadmap& before, const LinkIndex& index, const Stances& stances,
                                        const Checker& after, std::span<const Obstacles::Change> changes,
                                        Repair& repair) {
  Recheck recheck(before, stances, after, repair);
  std::vector<char> is_done(before.places.size() + before.links.size(), 0);
  const auto once = [&](std::size_t entry) { return std::exchange(is_done[entry], 1) == 0; };
  for (const Obstacles::Change& change : changes)
    for (const Obstacles::Pointer& obstacle : {change.before, change.after})
      if (obstacle)
        index.visit(
            regionOf(obstacle->box),
            [&](LinkId id) {
              if (once(before.places.size() + id)) recheck.link(id);
            },
            [&](PlaceId id) {
              if (once(id)) recheck.place(id);
            });
  return recheck.result();
}

std::shared_ptr<const Roadmap> revalidated(const Roadmap& before, const Stances& stances, const Checker& after,
                                           Repair& repair) {
  Recheck recheck(before, stances, after, repair);
  for (PlaceId id = 0; id < before.places.size(); ++id) recheck.place(id);
  for (LinkId id = 0; id < before.links.size(); ++id)
    if (isFirstOfTwo(before, id)) recheck.link(id);
  return recheck.result();
}

}  // namespace underway
