#pragma once

#include "geometry/checker.hpp"

namespace underway {

/// Where to ask for a plan from, standing in a mode where it is believed: there, or if something is nearer
/// than the robot's margin, the nearest pose that keeps it, 2 cm and 0.05 rad away at most. A plan keeps no
/// more anywhere than its start has, so a belief that is off by a centimetre would let it scrape along walls;
/// no belief is surer than that. If no such pose is near, the one that keeps most.
[[nodiscard]] Pose startFrom(const Checker& checker, ModeId mode, const Pose& believed);

}  // namespace underway
