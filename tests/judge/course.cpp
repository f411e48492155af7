#include "tests/judge/course.hpp"

#include <algorithm>
#include <cmath>

namespace judge {
namespace {

constexpr double kOnTheEdge_m = 1e-9;

/// A circle that holds the body at every sample.
Circle circleRound(const Course& course) {
  Circle reach = judge::circleRound(course.bodyAt(0.5));
  for (std::size_t i = 0; i <= course.steps; ++i)
    for (const Vec2 corner : course.bodyAt(static_cast<double>(i) / static_cast<double>(course.steps)))
      reach.radius = std::max(reach.radius, norm(corner - reach.center));
  return reach;
}

/// Whether two circles come nearer to each other than `by_m`.
bool areNear(const Circle& a, const Circle& b, double by_m) {
  return norm(a.center - b.center) - a.radius - b.radius < by_m;
}

/// Calls `visit(t)` at every sample from t_min to t_max.
template <class Visit>
void forEachSample(double t_min, double t_max, std::size_t steps, Visit visit) {
  for (std::size_t i = 0; i <= steps; ++i)
    visit(t_min + (t_max - t_min) * static_cast<double>(i) / static_cast<double>(steps));
}

struct Closest {
  double distance_m = 0.0;
  double t = 0.0;
};

/// `distanceAt(t, best)` may answer anything from best up when it is not below best.
template <class DistanceAt>
double leastAlong(const Course& course, double most_m, DistanceAt distance_at) {
  constexpr std::size_t kStepsInside = 20;
  constexpr double kFiner = 10.0;
  Closest best{most_m, 0.0};
  const auto look = [&](double t) {
    const double distance_m = distance_at(t, best.distance_m);
    if (distance_m < best.distance_m) best = {distance_m, t};
  };
  forEachSample(0.0, 1.0, course.steps, look);
  double reach = 1.0 / static_cast<double>(course.steps);
  for (int finer = 0; finer < 3 && best.distance_m < most_m; ++finer, reach /= kFiner)
    forEachSample(std::max(0.0, best.t - reach), std::min(1.0, best.t + reach), kStepsInside, look);
  return best.distance_m;
}

bool isInside(const Polygon& polygon, Vec2 point) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (cross(side, point - polygon[i]) < -kOnTheEdge_m * norm(side)) return false;
  }
  return true;
}

struct Heights {
  double lowest_m = 0.0;
  double highest_m = 0.0;
};

Heights heightsOf(const Box& box) {
  const auto corners = cornersOf(box);
  const auto ends =
      std::minmax_element(corners.begin(), corners.end(), [](Vec3 a, Vec3 b) { return a.z < b.z; });
  return {ends.first->z, ends.second->z};
}

/// Whether a box may hang over a body that touches nothing: upright boxes that reach below the height stand
/// beside it.
bool mayHang(const Box& box, const Heights& heights, double height_m) {
  const bool upright = box.rpy_rad.x == 0.0 && box.rpy_rad.y == 0.0;
  return heights.highest_m > height_m && !(upright && heights.lowest_m <= height_m);
}

}  // namespace

View viewOf(const Scene& scene, double z_min, double z_max) {
  View view;
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    Polygon shape = footprint(scene.boxes[i], z_min, z_max);
    if (shape.empty()) continue;
    const Circle circle = circleRound(shape);
    view.pieces.push_back({i, std::move(shape), circle});
  }
  return view;
}

double leastDistance(const Course& course, const View& view, double most_m) {
  const Circle reach = circleRound(course);
  std::vector<const View::Piece*> near;
  for (const View::Piece& piece : view.pieces)
    if (areNear(piece.circle, reach, most_m)) near.push_back(&piece);
  return leastAlong(course, most_m, [&](double t, double best_m) {
    const Polygon body = course.bodyAt(t);
    const Circle circle = judge::circleRound(body);
    for (const View::Piece* piece : near)
      if (areNear(piece->circle, circle, best_m)) best_m = std::min(best_m, distance(body, piece->footprint));
    return best_m;
  });
}

double leastDistance(const Course& course, const Polygon& polygon) {
  return leastAlong(course, std::numeric_limits<double>::max(),
                    [&](double t, double) { return distance(course.bodyAt(t), polygon); });
}

bool staysInside(const Course& course, const Polygon& bounds) {
  bool inside = true;
  forEachSample(0.0, 1.0, course.steps, [&](double t) {
    for (const Vec2 corner : course.bodyAt(t)) inside = inside && isInside(bounds, corner);
  });
  return inside;
}

double headroom(const Course& course, const Scene& scene, double height_m) {
  const Circle reach = circleRound(course);
  double lowest_over = std::numeric_limits<double>::infinity();
  for (const Box& box : scene.boxes) {
    const Heights heights = heightsOf(box);
    if (!mayHang(box, heights, height_m)) continue;
    const Circle shadow = judge::circleRound(footprint(box, heights.lowest_m, heights.highest_m));
    if (!areNear(shadow, reach, kOnTheEdge_m)) continue;
    forEachSample(0.0, 1.0, course.steps, [&](double t) {
      if (heights.lowest_m >= lowest_over) return;  // lower than this it cannot hang
      const Polygon body = course.bodyAt(t);
      if (!areNear(shadow, judge::circleRound(body), kOnTheEdge_m)) return;
      if (const auto height = lowestOver(box, body, height_m)) lowest_over = std::min(lowest_over, *height);
    });
  }
  return lowest_over - height_m;
}

}  // namespace judge
