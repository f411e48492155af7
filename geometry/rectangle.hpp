#pragma once

#include <array>

#include "geometry/box.hpp"
#include "geometry/convex.hpp"

namespace underway {

/// A rectangle in the plane.
struct Rectangle {
  Point center;      ///< map frame [m]
  double cos = 1.0;  ///< direction of its x axis in the map frame
  double sin = 0.0;
  double half_x = 0.0;  ///< half its size along its own axes [m]
  double half_y = 0.0;
};

/// The corners, counter-clockwise.
[[nodiscard]] std::array<Point, 4> cornersOf(const Rectangle& rectangle);
/// What an upright box covers of the floor.
[[nodiscard]] Rectangle footprintOf(const OrientedBox& upright);
/// The smallest rectangle along an edge round some corners, at least one.
[[nodiscard]] Rectangle rectangleAround(ConvexView corners);

}  // namespace underway
