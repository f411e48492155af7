#pragma once

#include "local/command.hpp"
#include "planner/plan.hpp"

namespace underway {

/// Where a pose is beside a translation: how far along, how far to its left, how much turned from its
/// heading.
struct OnLane {
  double along_m = 0.0;     ///< from the translation's beginning, in its direction
  double left_m = 0.0;      ///< across its direction
  double turned_rad = 0.0;  ///< from its heading
};
[[nodiscard]] OnLane onLane(const Motion& translation, const Pose& at);
/// The translation beside it, so far to its left.
[[nodiscard]] Motion shifted(const Motion& translation, double left_m);
/// A point that lies so far along a translation [map frame].
[[nodiscard]] Point pointAlong(const Motion& translation, double along_m);

}  // namespace underway
