#include "tests/judge/plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace judge {
namespace {

double distanceToSegment(Vec2 point, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0.0 ? std::clamp(dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
  return norm(point - (a + t * along));
}

bool contains(const Polygon& polygon, Vec2 point) {
  if (polygon.size() < 3) return false;  // a line or a point has no inside; its edge is measured
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    if (cross(b - a, point - a) < 0.0) return false;
  }
  return true;
}

bool cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

bool edgesCross(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (cross(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
  return false;
}

}  // namespace

double norm(Vec2 a) { return std::hypot(a.x, a.y); }

Vec2 rotated(Vec2 a, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

Vec2 placed(const Pose& pose, Vec2 local) { return pose.position() + rotated(local, pose.yaw); }

double wrapped(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

Polygon convexHull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Andrew's monotone chain: the lower side from left to right, then the upper side back.
  Polygon hull;
  const auto add = [&](Vec2 point, std::size_t kept) {
    while (hull.size() > kept && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const Vec2 point : points) add(point, 1);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

double distance(Vec2 point, const Polygon& polygon) {
  if (contains(polygon, point)) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  return nearest;
}

double distance(const Polygon& a, const Polygon& b) {
  // Apart, two convex polygons are closest at a corner of one of them. Overlapping, a corner lies inside or
  // edges cross.
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2 corner : a) nearest = std::min(nearest, distance(corner, b));
  for (const Vec2 corner : b) nearest = std::min(nearest, distance(corner, a));
  return nearest > 0.0 && edgesCross(a, b) ? 0.0 : nearest;
}

Circle circleRound(const Polygon& polygon) {
  Circle circle;
  for (const Vec2 corner : polygon)
    circle.center = circle.center + (1.0 / static_cast<double>(polygon.size())) * corner;
  for (const Vec2 corner : polygon) circle.radius = std::max(circle.radius, norm(corner - circle.center));
  return circle;
}

Polygon placed(const Pose& pose, const Rect& rect) {
  return {placed(pose, Vec2{rect.x_min, rect.y_min}), placed(pose, Vec2{rect.x_max, rect.y_min}),
          placed(pose, Vec2{rect.x_max, rect.y_max}), placed(pose, Vec2{rect.x_min, rect.y_max})};
}

}  // namespace judge
