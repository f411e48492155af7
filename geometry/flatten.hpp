#pragma once

#include <optional>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/convex.hpp"

namespace underway {

/// What ends this near to a height reaches it: the rounding of heights.
inline constexpr double kFlush_m = 1e-11;

/// Whether a box stands upright: neither rolled nor pitched.
[[nodiscard]] bool isUpright(const OrientedBox& box);

/// Whether an upright box reaches into a slab of heights (closed).
[[nodiscard]] bool reachesInto(const OrientedBox& upright, Range slab);

/// The part of a box between two heights (closed), projected to the floor: corners counter-clockwise, map
/// frame [m]; empty when there is none. Four corners, in the box's own order, if the box is upright.
[[nodiscard]] std::vector<Point> flattened(const OrientedBox& box, Range slab);

/// The lowest point of a box among those at or above a height and over a convex area of the floor; empty when
/// the box is nowhere there. Right as long as the box does not touch the area at exactly that height.
[[nodiscard]] std::optional<double> lowestAbove(const OrientedBox& box, ConvexView area, double height_m);

}  // namespace underway
