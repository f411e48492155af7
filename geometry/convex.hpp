#pragma once

#include <span>
#include <vector>

#include "geometry/pose.hpp"

namespace underway {

/// A convex polygon: corners counter-clockwise, map frame [m]. One or two corners are a point and a line.
using ConvexView = std::span<const Point>;

/// Corners of the convex hull, counter-clockwise, without corners in line.
[[nodiscard]] std::vector<Point> convexHull(std::vector<Point> points);

/// Nearer than this is touching. Rounding of coordinates within 100 km stays well below it, so no contact is
/// missed; and no answer further than this from contact depends on it.
inline constexpr double kContact_m = 1e-9;

/// How far apart two convex sets are, and where on the second.
struct Gap {
  double distance_m = 0.0;  ///< 0 when they touch or overlap, and only then; never above the truth
  Point at;                 ///< the second set's point nearest to the first; meaningless when they overlap
};

/// Whether two convex sets come nearer than kContact_m. What is not finite touches everything.
[[nodiscard]] bool areTouching(ConvexView a, ConvexView b);

/// At most 2 kContact_m below the truth: separating axes decide overlap, corners against edges the distance.
[[nodiscard]] Gap gapBetween(ConvexView a, ConvexView b);

/// From a point to a convex set; 0 inside.
[[nodiscard]] double distanceTo(ConvexView set, Point point);

/// A measured distance between sets that do not touch, as it may be told: less kContact_m, never 0.
[[nodiscard]] double told(double distance_m);

/// The point of a segment nearest to a point.
[[nodiscard]] Point nearestOnSegment(Point p, Point a, Point b);

}  // namespace underway
