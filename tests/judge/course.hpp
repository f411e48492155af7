#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "tests/judge/plane.hpp"
#include "tests/judge/scene.hpp"

namespace judge {

/// A body on its way: a rectangle at poses for t from 0 to 1, sampled so finely that nothing slips through.
struct Course {
  Rect body;
  std::function<Pose(double t)> at;
  std::size_t steps = 1;  ///< samples are taken at 0, 1/steps, ..., 1

  [[nodiscard]] Polygon bodyAt(double t) const { return placed(at(t), body); }
};

/// What a mode sees: footprints of the map's boxes in a slab of heights.
struct View {
  struct Piece {
    std::size_t box = 0;  ///< index into Scene::boxes
    Polygon footprint;
    Circle circle;
  };
  std::vector<Piece> pieces;
};
View viewOf(const Scene& scene, double z_min, double z_max);

/// The least distance to anything in view [m], no more than `most` [m]. The samples, then three ever finer
/// looks around the closest: right to a few micrometres for motions that turn, and exact for those that do
/// not.
double leastDistance(const Course& course, const View& view, double most_m);

/// The least distance between a course and one polygon [m].
double leastDistance(const Course& course, const Polygon& polygon);

/// Whether all corners at all samples lie inside a polygon or outside it by no more than 1e-9 m.
bool staysInside(const Course& course, const Polygon& bounds);

/// The smallest gap between `height_m` and what hangs over the body anywhere on its way [m]; infinite if
/// nothing does.
double headroom(const Course& course, const Scene& scene, double height_m);

}  // namespace judge
