#pragma once

#include <array>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/convex.hpp"

namespace underway::proof {

/// A convex polygon with its edges ready for separating axes: corners counter-clockwise [m]; the points of it
/// are those with normal . point <= offset for every edge.
struct Outline {
  std::vector<Point> corners;
  std::vector<Point> normals;   ///< unit length, outwards, one an edge
  std::vector<double> offsets;  ///< [m]

  /// The furthest it reaches in a direction of unit length [m].
  [[nodiscard]] double reach(Point direction) const;
};
/// With the edges' normals; a line has two, a point none.
[[nodiscard]] Outline outlineOf(std::vector<Point> corners);

/// A footprint: ranges in the body frame, kept `margin_m` from everything.
struct Footprint {
  Range x;                ///< [m]
  Range y;                ///< [m]
  double margin_m = 0.0;  ///< rounded at the corners here: the least that any reading of 'margin' asks for
};

/// A footprint at all headings of a range at once, about the body frame's origin, which is at (0, 0).
struct Core {
  Outline common;               ///< points that it covers at every heading; no corners: there may be none
  std::vector<Point> middle;    ///< corners at the middle heading, margin included
  std::vector<Point> all;       ///< it stays within the hull of these at every heading, margin included
  std::array<double, 4> least;  ///< it reaches at least so far in +x, +y, -x, -y, without the margin [m]
  std::array<double, 4> most;   ///< and at most so far [m]
  double radius_m = 0.0;        ///< of a circle round `all`
};

/// For headings within `half_rad` (at most pi / 4) of `yaw_rad`. `common` is the body cut by the tangents of
/// the arcs its edges turn on, and inscribed in those arcs by chords: exact on the flat of an edge but for
/// half_rad^2 / 8 of its distance.
[[nodiscard]] Core coreOf(const Footprint& footprint, double yaw_rad, double half_rad);

}  // namespace underway::proof
