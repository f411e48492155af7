#pragma once

#include <cmath>

#include "geometry/box.hpp"
#include "geometry/pose.hpp"

namespace underway {

/// A rectangle along the axes of a frame [m].
struct Extent {
  Range x;
  Range y;
};

/// What lies within a distance of a point along both axes.
[[nodiscard]] inline Extent round(Point at, double reach_m) {
  return {{at.x - reach_m, at.x + reach_m}, {at.y - reach_m, at.y + reach_m}};
}

/// The smallest that holds a body in a pose.
[[nodiscard]] inline Extent extentOf(const BodyBox& body, const Pose& at) {
  const Point middle = transform(at, {0.5 * (body.x.min + body.x.max), 0.5 * (body.y.min + body.y.max)});
  const double c = std::abs(std::cos(at.yaw));
  const double s = std::abs(std::sin(at.yaw));
  const double half_x = 0.5 * (c * body.x.length() + s * body.y.length());
  const double half_y = 0.5 * (s * body.x.length() + c * body.y.length());
  return {{middle.x - half_x, middle.x + half_x}, {middle.y - half_y, middle.y + half_y}};
}

}  // namespace underway
