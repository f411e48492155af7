#pragma once

#include "bench/oracle/gaits.hpp"
#include "bench/oracle/keep.hpp"
#include "planner/cost.hpp"
#include "planner/route.hpp"

namespace underway::bench {

/// The way back along a motion that is no switch: the same sweep, the other way round. `mode` does it.
[[nodiscard]] Motion reversed(const Motion& motion, ModeId mode);

/// A route that holds no switches between companion modes and may miss its own points by rounding, made
/// whole: chained bit for bit from `start`, motions in line joined where that is free, switches between
/// companions put in.
[[nodiscard]] Route chained(const Checker& checker, const Keep& keep, const Gaits& gaits, const Route& route,
                            const Request& request);

/// Sum over the motions.
[[nodiscard]] Cost totalCost(const Robot& robot, Policy policy, const Route& route);

/// Timed, and with its clearances, as a plan is.
[[nodiscard]] Plan planOf(const Checker& checker, const Route& route, const Request& request);

}  // namespace underway::bench
