#pragma once

#include <optional>
#include <vector>

#include "bench/oracle/chain.hpp"

namespace underway::bench {

/// A place on the way, in a gait.
struct Spot {
  Point at;
  GaitId gait = 0;
  bool operator==(const Spot&) const = default;
};

/// What is done between two spots at given headings: one translation, or a bridge: switches and what lies
/// between them.
struct Leg {
  Route motions;
  double yaw_in = 0.0;   ///< it begins with [rad]
  double yaw_out = 0.0;  ///< it ends with [rad]

  [[nodiscard]] bool isBridge() const {
    return motions.size() > 1 || motions.front().kind == MotionKind::kSwitch;
  }
};

/// A route without its turns, which follow from the headings of the legs: legs[i] leads from spots[i] to
/// spots[i + 1].
struct Way {
  std::vector<Spot> spots;
  std::vector<Leg> legs;
  double start_yaw = 0.0;
  std::optional<double> goal_yaw;  ///< empty: any

  [[nodiscard]] double yawBefore(std::size_t spot) const {
    return spot == 0 ? start_yaw : legs[spot - 1].yaw_out;
  }
  [[nodiscard]] std::optional<double> yawAfter(std::size_t spot) const {
    return spot == legs.size() ? goal_yaw : std::optional(legs[spot].yaw_in);
  }
};

/// What the parts of the search share.
struct Terrain {
  const Checker& checker;
  const Keep& keep;
  const Gaits& gaits;
  Policy policy;

  [[nodiscard]] const Robot& robot() const { return checker.robot(); }
  [[nodiscard]] Cost cost(const Motion& motion) const { return costOf(robot(), policy, motion); }
  /// The free turn of a gait at a point, the shorter way round if that is free, else the other; none needed
  /// (an angle of 0) if the headings are the same but for rounding. Empty if neither is free.
  [[nodiscard]] std::optional<Motion> freeTurn(const Spot& at, double from_yaw, double to_yaw) const;
};

/// Switches between companions are left out. Empty if the route is of a form no way has.
[[nodiscard]] std::optional<Way> wayOf(const Gaits& gaits, const Route& route, const Request& request);
/// With the turns put in; empty if one of them is not free.
[[nodiscard]] std::optional<Route> routeOf(const Terrain& terrain, const Way& way);
/// Cost::most() if a turn is not free.
[[nodiscard]] Cost costOf(const Terrain& terrain, const Way& way);

}  // namespace underway::bench
