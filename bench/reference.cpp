#include "bench/reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace underway::bench::reference {
namespace {

Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3 operator*(double t, const Vec3& a) { return {t * a.x, t * a.y, t * a.z}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A box by its middle, its three directions and half its sizes.
struct Solid {
  Vec3 center;
  std::array<Vec3, 3> axes;
  std::array<double, 3> half;

  [[nodiscard]] double radiusAlong(const Vec3& axis) const {
    return half[0] * std::abs(dot(axes[0], axis)) + half[1] * std::abs(dot(axes[1], axis)) +
           half[2] * std::abs(dot(axes[2], axis));
  }
  [[nodiscard]] Vec3 corner(unsigned i) const {
    const auto sign = [i](unsigned bit) { return (i >> bit & 1U) != 0 ? 1.0 : -1.0; };
    return center + sign(0) * half[0] * axes[0] + sign(1) * half[1] * axes[1] + sign(2) * half[2] * axes[2];
  }
};

Solid solidOf(const OrientedBox& box) {
  const Rotation rows = rotation(box);
  return {box.center_m,
          {Vec3{rows[0].x, rows[1].x, rows[2].x}, Vec3{rows[0].y, rows[1].y, rows[2].y},
           Vec3{rows[0].z, rows[1].z, rows[2].z}},
          {0.5 * box.size_m.x, 0.5 * box.size_m.y, 0.5 * box.size_m.z}};
}

Solid solidOf(const Prism& body) {
  const double c = std::cos(body.frame.yaw);
  const double s = std::sin(body.frame.yaw);
  const double x = 0.5 * (body.x.min + body.x.max);
  const double y = 0.5 * (body.y.min + body.y.max);
  return {{body.frame.x + c * x - s * y, body.frame.y + s * x + c * y, 0.5 * (body.z.min + body.z.max)},
          {Vec3{c, s, 0.0}, Vec3{-s, c, 0.0}, Vec3{0.0, 0.0, 1.0}},
          {0.5 * body.x.length(), 0.5 * body.y.length(), 0.5 * body.z.length()}};
}

/// Without repetitions: an edge of no length has no direction to judge by.
std::vector<Point> distinct(const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point p : points) {
    const bool is_known = std::any_of(kept.begin(), kept.end(),
                                      [p](Point q) { return std::hypot(p.x - q.x, p.y - q.y) < 1e-10; });
    if (!is_known) kept.push_back(p);
  }
  return kept;
}

/// Gift wrapping: from the lowest point on, always to the point that has all others to its left. Of points in
/// line, but for rounding, to the furthest.
std::vector<Point> wrapped(const std::vector<Point>& points) {
  if (points.empty()) return {};
  constexpr double kInLine_m = 2e-10;  // above the rounding of coordinates within 100 km
  const auto is_lower = [](Point a, Point b) { return a.y < b.y || (a.y == b.y && a.x < b.x); };
  std::vector<Point> hull;
  Point here = *std::min_element(points.begin(), points.end(), is_lower);
  while (std::find(hull.begin(), hull.end(), here) == hull.end()) {
    hull.push_back(here);
    const auto away = [here](Point q) { return std::hypot(q.x - here.x, q.y - here.y); };
    Point next = here;
    for (const Point p : points) {
      const double turn = (next.x - here.x) * (p.y - here.y) - (next.y - here.y) * (p.x - here.x);
      const double slack = kInLine_m * std::max(away(p), away(next));
      if (turn < -slack || (turn <= slack && away(p) > away(next))) next = p;
    }
    here = next;
  }
  return hull;
}

double fromSegment(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  double t = squared > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0.0;
  t = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Whether some edge of a has all of b further out than all of a.
bool isSplit(const std::vector<Point>& a, const std::vector<Point>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point from = a[i];
    const Point to = a[(i + 1) % a.size()];
    const auto inwards = [&](Point p) {
      return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    };
    double furthest_out = 0.0;
    for (const Point p : a) furthest_out = std::min(furthest_out, inwards(p));
    if (std::all_of(b.begin(), b.end(), [&](Point p) { return inwards(p) < furthest_out; })) return true;
  }
  return false;
}

}  // namespace

double separation(const Prism& body, const OrientedBox& box) {
  const Solid a = solidOf(body);
  const Solid b = solidOf(box);
  const Vec3 between = b.center - a.center;
  double best = -std::numeric_limits<double>::infinity();
  const auto consider = [&](const Vec3& axis) {
    const double length = std::sqrt(dot(axis, axis));
    if (length < 1e-6) return;  // of parallel edges: their faces' axes tell
    best =
        std::max(best, (std::abs(dot(between, axis)) - a.radiusAlong(axis) - b.radiusAlong(axis)) / length);
  };
  for (const Vec3& axis : a.axes) consider(axis);
  for (const Vec3& axis : b.axes) consider(axis);
  for (const Vec3& of_a : a.axes)
    for (const Vec3& of_b : b.axes) consider(cross(of_a, of_b));
  return best;
}

std::vector<Point> shadow(const OrientedBox& box, Range slab) {
  const Solid solid = solidOf(box);
  std::vector<Point> points;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 from = solid.corner(i);
    if (from.z >= slab.min && from.z <= slab.max) points.push_back({from.x, from.y});
    for (unsigned bit = 1; bit <= 4; bit *= 2) {
      if ((i & bit) != 0) continue;
      const Vec3 to = solid.corner(i | bit);
      for (const double z : {slab.min, slab.max}) {
        if ((from.z < z && to.z < z) || (from.z > z && to.z > z) || from.z == to.z) continue;
        const Vec3 cut = from + (z - from.z) / (to.z - from.z) * (to - from);
        points.push_back({cut.x, cut.y});
      }
    }
  }
  return wrapped(distinct(points));
}

double distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      least = std::min(least, fromSegment(a[i], b[k], b[(k + 1) % b.size()]));
      least = std::min(least, fromSegment(b[k], a[i], a[(i + 1) % a.size()]));
    }
  }
  return isSplit(a, b) || isSplit(b, a) ? least : 0.0;
}

Bracket distanceOfTurn(const Prism& body, double angle_rad, const std::vector<Point>& shadow,
                       double tolerance_m, double enough_m) {
  const double reach = std::hypot(std::max(-body.x.min, body.x.max), std::max(-body.y.min, body.y.max));
  Bracket bracket{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const auto search = [&](const auto& self, double middle, double half) -> void {
    Prism turned = body;
    turned.frame.yaw += middle;
    const auto corners = turned.footprint();
    const double here = distance({corners.begin(), corners.end()}, shadow);
    bracket.at_most_m = std::min(bracket.at_most_m, here);
    const double least = here - reach * half;
    if (least > enough_m || least > bracket.at_most_m - tolerance_m || reach * half < tolerance_m) {
      bracket.at_least_m = std::min(bracket.at_least_m, std::max(least, 0.0));
      return;
    }
    self(self, middle - 0.5 * half, 0.5 * half);
    if (bracket.at_most_m > 0.0) self(self, middle + 0.5 * half, 0.5 * half);
  };
  search(search, 0.5 * angle_rad, 0.5 * std::abs(angle_rad));
  if (bracket.at_most_m == 0.0) bracket.at_least_m = 0.0;
  return bracket;
}

}  // namespace underway::bench::reference
