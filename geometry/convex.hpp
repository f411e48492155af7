#pragma once

#include <span>
#include <vector>

#include "geometry/pose.hpp"

namespace underway {

/// A convex polygon: corners counter-clockwise, map frame [m]. One or two corners are a point and a line.
using ConvexView = std::span<const Point>;

/// Corners of the convex hull, counter-clockwise, without corners in line.
[[nodiscard]] std::vector<Point> convexHull(std::vector<Point> points);

/// How far apart two convex sets are, and where on the second.
struct Gap {
  double distance_m = 0.0;  ///< 0 when they touch or overlap
  Point at;                 ///< the second set's point nearest to the first; meaningless when they overlap
};

/// Exact up to rounding: separating axes decide overlap, corners against edges the distance.
[[nodiscard]] Gap gapBetween(ConvexView a, ConvexView b);

/// From a point to a convex set; 0 inside.
[[nodiscard]] double distanceTo(ConvexView set, Point point);

}  // namespace underway
