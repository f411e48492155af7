#include "geometry/rectangle.hpp"

#include <cmath>
#include <limits>

namespace underway {
namespace {

/// The rectangle along one edge.
Rectangle rectangleAlong(ConvexView corners, Point from, Point to) {
  const double length = std::sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y));
  Rectangle box;
  if (length > 0.0) box.cos = (to.x - from.x) / length, box.sin = (to.y - from.y) / length;
  Range along{0.0, 0.0};
  Range across{0.0, 0.0};
  for (const Point p : corners) {
    const double dx = p.x - from.x;
    const double dy = p.y - from.y;
    const double u = box.cos * dx + box.sin * dy;
    const double v = box.cos * dy - box.sin * dx;
    along = hull(along, {u, u});
    across = hull(across, {v, v});
  }
  const double u = 0.5 * (along.min + along.max);
  const double v = 0.5 * (across.min + across.max);
  box.center = {from.x + box.cos * u - box.sin * v, from.y + box.sin * u + box.cos * v};
  box.half_x = 0.5 * along.length();
  box.half_y = 0.5 * across.length();
  return box;
}

}  // namespace

Rectangle footprintOf(const OrientedBox& upright) {
  return {{upright.center_m.x, upright.center_m.y},
          std::cos(upright.rpy_rad.z),
          std::sin(upright.rpy_rad.z),
          0.5 * upright.size_m.x,
          0.5 * upright.size_m.y};
}

std::array<Point, 4> cornersOf(const Rectangle& r) {
  const auto at = [&](double x, double y) {
    return Point{r.center.x + r.cos * x - r.sin * y, r.center.y + r.sin * x + r.cos * y};
  };
  return {at(-r.half_x, -r.half_y), at(r.half_x, -r.half_y), at(r.half_x, r.half_y), at(-r.half_x, r.half_y)};
}

Rectangle rectangleAround(ConvexView corners) {
  Rectangle best;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Rectangle box = rectangleAlong(corners, corners[i], corners[(i + 1) % corners.size()]);
    if (const double area = box.half_x * box.half_y; area < smallest) smallest = area, best = box;
  }
  return best;
}

}  // namespace underway
