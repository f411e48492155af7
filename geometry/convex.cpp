#include "geometry/convex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace underway {
namespace {

double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

double squaredDistance(Point a, Point b) { return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y); }

/// Whether all of b lies beyond one end of a line, by more than a contact.
bool isBeyondAnEnd(Point a, Point b, ConvexView set) {
  const double length = std::sqrt(squaredDistance(a, b));
  const double beyond = kContact_m * length;
  const auto along = [&](Point p) { return (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y); };
  return std::all_of(set.begin(), set.end(), [&](Point p) { return along(p) < -beyond; }) ||
         std::all_of(set.begin(), set.end(), [&](Point p) { return along(p) > length * length + beyond; });
}

/// Whether all of b lies outside one of a's edges, by more than a contact, and all of a does not: a corner
/// that rounding has pushed in or out by less than a picometre turns a short edge so far that, metres on, its
/// line cuts a. Of a line the ends count as edges.
bool hasSeparatingEdge(ConvexView a, ConvexView b) {
  if (a.size() < 2) return false;
  if (a.size() == 2 && isBeyondAnEnd(a[0], a[1], b)) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point from = a[i];
    const Point to = a[(i + 1) % a.size()];
    const auto outside = [&](Point p) { return -cross(from, to, p); };
    double own = 0.0;
    for (const Point p : a) own = std::max(own, outside(p));
    const double beyond = own + kContact_m * std::sqrt(squaredDistance(from, to));
    if (std::all_of(b.begin(), b.end(), [&](Point p) { return outside(p) > beyond; })) return true;
  }
  return false;
}

/// Of two single points no edge can tell that they are apart.
bool arePointsApart(ConvexView a, ConvexView b) {
  return a.size() == 1 && b.size() == 1 && squaredDistance(a[0], b[0]) > kContact_m * kContact_m;
}

}  // namespace

std::vector<Point> convexHull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;  // Andrew's monotone chain: the lower side, then the upper
  const auto extend = [&hull](Point p, std::size_t keep) {
    while (hull.size() >= keep + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
    hull.push_back(p);
  };
  for (const Point p : points) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) extend(*p, lower);
  hull.pop_back();
  return hull;
}

Point nearestOnSegment(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  if (squared == 0.0) return a;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0);
  return {a.x + t * dx, a.y + t * dy};
}

bool areTouching(ConvexView a, ConvexView b) {
  return !hasSeparatingEdge(a, b) && !hasSeparatingEdge(b, a) && !arePointsApart(a, b);
}

double told(double distance_m) {
  constexpr double kLeast_m = 1e-12;
  return std::max(distance_m - kContact_m, kLeast_m);
}

Gap gapBetween(ConvexView a, ConvexView b) {
  if (areTouching(a, b)) return {0.0, b.front()};
  double least = std::numeric_limits<double>::infinity();  // squared
  Point at;
  const auto consider = [&](Point on_a, Point on_b) {
    if (const double d = squaredDistance(on_a, on_b); d < least) least = d, at = on_b;
  };
  for (const Point corner : a)
    for (std::size_t i = 0; i < b.size(); ++i)
      consider(corner, nearestOnSegment(corner, b[i], b[(i + 1) % b.size()]));
  for (const Point corner : b)
    for (std::size_t i = 0; i < a.size(); ++i)
      consider(nearestOnSegment(corner, a[i], a[(i + 1) % a.size()]), corner);
  return {told(std::sqrt(least)), at};
}

double distanceTo(ConvexView set, Point point) { return gapBetween(std::span(&point, 1), set).distance_m; }

}  // namespace underway
