#pragma once

#include "geometry/checker.hpp"
#include "planner/interrupt.hpp"
#include "planner/route.hpp"

namespace underway {

/// What a shortened route must keep.
struct Keeping {
  double start_m = 0.0;      ///< clearance on motions that begin at the start [m]
  double goal_m = 0.0;       ///< clearance on motions that end at the goal [m]
  double at_least_m = 0.0;   ///< clearance on all others, beyond the margin [m]
  bool any_heading = false;  ///< at the goal
};

/// A route that costs no more: the best one through the route's own points and points close to them. It is
/// found as any route is, on a small roadmap made of those points, which holds the old route too; repeated
/// with ever closer points. When interrupted, the best so far.
[[nodiscard]] Route shortened(const Checker& checker, Policy policy, Route route, const Keeping& keeping,
                              Interrupt& interrupt);

}  // namespace underway
