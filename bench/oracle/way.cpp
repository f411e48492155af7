#include "bench/oracle/way.hpp"

#include <cmath>
#include <numbers>

namespace underway::bench {
namespace {

constexpr double kSame_rad = 1e-12;

/// Adds one motion to a way that is being read.
class Reader {
 public:
  Reader(const Gaits& gaits, const Request& request) : gaits_(gaits) {
    way_.start_yaw = request.start.yaw;
    way_.goal_yaw = request.goal_yaw;
    way_.spots.push_back({request.start.position(), gaits.of_mode[request.start_mode]});
  }

  void add(const Motion& motion) {
    const GaitId from = gaits_.of_mode[motion.mode];
    const GaitId to = gaits_.of_mode[motion.to_mode];
    const bool is_of_bridge = from != to || !gaits_.all[from].turning;
    if (!is_of_bridge && motion.kind != MotionKind::kTranslate) return;  // a turn, or companions switching
    open_.push_back(motion);
    if (!is_of_bridge || (from != to && gaits_.all[to].turning)) close();
  }

  Way finish() {
    if (!open_.empty()) close();
    return std::move(way_);
  }

 private:
  void close() {
    way_.spots.push_back({open_.back().to.position(), gaits_.of_mode[open_.back().to_mode]});
    way_.legs.push_back({open_, open_.front().from.yaw, open_.back().to.yaw});
    open_.clear();
  }

  const Gaits& gaits_;
  Way way_;
  Route open_;  // the leg that is being read
};

}  // namespace

std::optional<Motion> Terrain::freeTurn(const Spot& at, double from_yaw, double to_yaw) const {
  const double angle = normalizedAngle(to_yaw - from_yaw);
  const Pose from{at.at.x, at.at.y, from_yaw};
  const Gait& gait = gaits.all[at.gait];
  if (std::abs(angle) < kSame_rad) return stay(gait.modes.front(), from);
  if (!gait.turning) return std::nullopt;
  const Motion shorter = turn(*gait.turning, from, angle, to_yaw);
  if (keep.isFree(shorter)) return shorter;
  const Motion longer =
      turn(*gait.turning, from, angle - std::copysign(2.0 * std::numbers::pi, angle), to_yaw);
  return keep.isFree(longer) ? std::optional(longer) : std::nullopt;
}

std::optional<Way> wayOf(const Gaits& gaits, const Route& route, const Request& request) {
  Reader reader(gaits, request);
  for (const Motion& motion : route) reader.add(motion);
  Way way = reader.finish();
  if (way.spots.back().gait != gaits.of_mode[request.goal_mode]) return std::nullopt;
  return way;
}

std::optional<Route> routeOf(const Terrain& terrain, const Way& way) {
  Route route;
  for (std::size_t i = 0; i < way.spots.size(); ++i) {
    if (const auto yaw = way.yawAfter(i)) {
      const auto turned = terrain.freeTurn(way.spots[i], way.yawBefore(i), *yaw);
      if (!turned) return std::nullopt;
      if (turned->angle_rad != 0.0) route.push_back(*turned);
    }
    if (i < way.legs.size())
      route.insert(route.end(), way.legs[i].motions.begin(), way.legs[i].motions.end());
  }
  return route;
}

Cost costOf(const Terrain& terrain, const Way& way) {
  const auto route = routeOf(terrain, way);
  return route ? totalCost(terrain.robot(), terrain.policy, *route) : Cost::most();
}

}  // namespace underway::bench
