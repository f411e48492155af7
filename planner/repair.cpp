#include "planner/repair.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
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

constexpr double kRounding_m = 1e-6;

/// No part of the robot, in any mode or switch, is further from its frame's origin, the margin included [m].
double reachOfRobot(const Robot& robot) {
  double reach = 0.0;
  for (const Mode& mode : robot.modes) reach = std::max(reach, reachOfBody(mode.body_m));
  for (const Switch& change : robot.switches) reach = std::max(reach, reachOfBody(change.body_m));
  return reach + 2.0 * robot.margin_m + kRounding_m;
}

/// The same of a group's modes and the switches among them.
double reachOfGroup(const Robot& robot, const Groups& groups, GroupId group) {
  double reach = 0.0;
  for (const ModeId mode : groups.modes[group])
    reach = std::max(reach, reachOfBody(robot.modes[mode].body_m));
  for (const Switch& change : robot.switches)
    if (groups.of_mode[change.from] == group && groups.of_mode[change.to] == group)
      reach = std::max(reach, reachOfBody(change.body_m));
  return reach + 2.0 * robot.margin_m + kRounding_m;
}

double distanceToSegment(Point point, Point a, Point b) {
  const Point along{b.x - a.x, b.y - a.y};
  const double squared = along.x * along.x + along.y * along.y;
  const double share =
      squared > 0.0 ? std::clamp(((point.x - a.x) * along.x + (point.y - a.y) * along.y) / squared, 0.0, 1.0)
                    : 0.0;
  return distance(point, {a.x + share * along.x, a.y + share * along.y});
}

Region regionOf(const OrientedBox& box) {
  const auto vertices = corners(box);
  Region region{vertices[0].x, vertices[0].y, vertices[0].x, vertices[0].y};
  for (const Vec3& vertex : vertices) region = region.joint({vertex.x, vertex.y, vertex.x, vertex.y});
  return region;
}

double driftOf(const Robot& robot) {
  double drift = 0.0;
  for (const Mode& mode : robot.modes) drift = std::max(drift, mode.drift_m_per_m);
  return drift;
}

Region regionOf(const Roadmap& roadmap, const Roadmap::Link& link, const Robot& robot) {
  const double drift = driftOf(robot);

  if (link.crossing == Roadmap::kNone)
    return Region::between(roadmap.places[link.from].at, roadmap.places[link.to].at)
        .grown(drift * link.length_m);
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
      set(id, roadmap_->crossings[link.crossing].isFree(checker_) ? 1 : 0);
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
  const Groups groups(robot);
  std::vector<double> reach;
  for (GroupId group = 0; group < groups.modes.size(); ++group)
    reach.push_back(reachOfGroup(robot, groups, group));
  const double widest = reachOfRobot(robot);
  std::vector<Region> regions;
  for (const Roadmap::Place& place : roadmap.places)
    regions.push_back(Region::between(place.at, place.at).grown(reach[place.group]));
  for (LinkId id = 0; id < roadmap.links.size(); ++id) {
    if (!isFirstOfTwo(roadmap, id)) continue;
    links_.push_back(id);
    const Roadmap::Link& link = roadmap.links[id];
    const bool is_crossing = link.crossing != Roadmap::kNone;
    regions.push_back(
        regionOf(roadmap, link, robot).grown(is_crossing ? widest : reach[roadmap.places[link.from].group]));
    reach_m_.push_back(is_crossing ? std::numeric_limits<double>::infinity()
                                   : reach[roadmap.places[link.from].group] + driftOf(robot) * link.length_m);
  }
  covered_ = RegionGrid(std::move(regions));
}

void LinkIndex::visit(const Roadmap& roadmap, const OrientedBox& box, const std::function<void(LinkId)>& link,
                      const std::function<void(PlaceId)>& place) const {
  const Region region = regionOf(box);
  const Point middle{box.center_m.x, box.center_m.y};
  const double half_m = 0.5 * std::hypot(region.max_x - region.min_x, region.max_y - region.min_y);
  covered_.visit(region, [&](std::uint32_t entry) {
    if (entry < places_) return place(entry);
    // The regions of slanting links are wide: most of what lies in them is not near the link.
    const LinkId id = links_[entry - places_];
    const Roadmap::Link& there = roadmap.links[id];
    const double away_m =
        distanceToSegment(middle, roadmap.places[there.from].at, roadmap.places[there.to].at);
    if (away_m <= half_m + reach_m_[entry - places_]) link(id);
  });
}

std::shared_ptr<const Roadmap> repaired(const Roadmap& before, const LinkIndex& index, const Stances& stances,
                                        const Checker& after, std::span<const Obstacles::Change> changes,
                                        Repair& repair) {
  Recheck recheck(before, stances, after, repair);
  std::vector<char> is_done(before.places.size() + before.links.size(), 0);
  const auto once = [&](std::size_t entry) { return std::exchange(is_done[entry], 1) == 0; };
  // What has gone can only open what was closed, what has come only close what was open.
  const auto may_change = [&](LinkId id, bool is_gone) {
    const Roadmap::Ways ways = before.ways[id];
    const LinkId twin = before.links[id].twin;
    const Roadmap::Ways back = twin == Roadmap::kNone ? ways : before.ways[twin];
    if (!is_gone) return ways != 0 || back != 0;
    return ways != before.links[id].tried || (twin != Roadmap::kNone && back != before.links[twin].tried);
  };
  const auto look = [&](const Obstacles::Pointer& obstacle, bool is_gone) {
    if (!obstacle) return;
    index.visit(
        before, obstacle->box,
        [&](LinkId id) {
          if (may_change(id, is_gone) && once(before.places.size() + id)) recheck.link(id);
        },
        [&](PlaceId id) {
          if (before.places[id].turns_freely != is_gone && once(id)) recheck.place(id);
        });
  };
  for (const Obstacles::Change& change : changes) {
    look(change.before, true);
    look(change.after, false);
  }
  return recheck.result();
}

std::shared_ptr<const Roadmap> revalidated(const Roadmap& before, const Stances& stances,
                                           const Checker& after, Repair& repair) {
  Recheck recheck(before, stances, after, repair);
  for (PlaceId id = 0; id < before.places.size(); ++id) recheck.place(id);
  for (LinkId id = 0; id < before.links.size(); ++id)
    if (isFirstOfTwo(before, id)) recheck.link(id);
  return recheck.result();
}

}  // namespace underway
