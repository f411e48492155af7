#pragma once

#include <vector>

#include "geometry/motion.hpp"
#include "geometry/robot.hpp"
#include "geometry/sweep.hpp"
#include "geometry/world.hpp"

/// The geometry over again, slow and obvious, to hold the fast one against: doubles, no index, separating
/// axes and distances of corners from edges. Shares with it only what says where a body is (sweep.hpp).
namespace underway::bench::reference {

/// How far apart an upright box and an oriented box are in space, along the best of their 15 separating axes
/// [m] (Gottschalk, Lin and Manocha 1996): positive exactly if they are apart, and then at most their
/// distance; else less what one would have to be moved to be.
[[nodiscard]] double separation(const Prism& body, const OrientedBox& box);

/// What a slab sees of a box, projected: corners of the convex hull; empty if nothing.
[[nodiscard]] std::vector<Point> shadow(const OrientedBox& box, Range slab);

/// Planar distance of two convex polygons; 0 if they overlap.
[[nodiscard]] double distance(const std::vector<Point>& a, const std::vector<Point>& b);

/// Where the least distance of a turning body from a shadow lies.
struct Bracket {
  double at_least_m;
  double at_most_m;
};

/// Of a body that turns about its frame's origin by a signed angle, by halving the turn: no point of the body
/// moves further than its distance from the pivot times the angle. Stops when it knows the least distance to
/// `tolerance_m`, or that it is more than `enough_m`.
[[nodiscard]] Bracket distanceOfTurn(const Prism& body, double angle_rad, const std::vector<Point>& shadow,
                                     double tolerance_m, double enough_m);

}  // namespace underway::bench::reference
