#include "planner/proof/core.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace underway::proof {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kMostCorners = 12;  // of a core: fewer are quicker, more are closer to the truth

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
Point unit(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

/// All points with normal . point <= offset.
struct HalfPlane {
  double angle_rad;  // of the normal
  double offset_m;
};

std::vector<Point> clipped(const std::vector<Point>& polygon, HalfPlane plane) {
  const Point normal = unit(plane.angle_rad);
  std::vector<Point> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    const double over_a = dot(normal, a) - plane.offset_m;
    const double over_b = dot(normal, b) - plane.offset_m;
    if (over_a <= 0.0) inside.push_back(a);
    if ((over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0)) {
      const double t = over_a / (over_a - over_b);
      inside.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return inside;
}

/// The edges of a footprint. A corner of the margin is cut from where one side's margin ends to where the
/// other's does.
std::vector<HalfPlane> edgesOf(const Footprint& footprint) {
  const double m = footprint.margin_m;
  const std::array<double, 4> sides{footprint.x.max, footprint.y.max, -footprint.x.min, -footprint.y.min};
  std::vector<HalfPlane> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = 0.5 * kPi * static_cast<double>(i);
    edges.push_back({angle, sides[i] + m});
    if (m > 0.0) edges.push_back({angle + 0.25 * kPi, std::sqrt(0.5) * (sides[i] + sides[(i + 1) % 4] + m)});
  }
  return edges;
}

/// Leaves out the corners that cost least: what remains lies inside.
void thinOut(std::vector<Point>& polygon) {
  const auto cost = [&](std::size_t i) {
    const std::size_t n = polygon.size();
    const Point a = polygon[(i + n - 1) % n], b = polygon[i], c = polygon[(i + 1) % n];
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  };
  while (polygon.size() > kMostCorners) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i)
      if (cost(i) < cost(least)) least = i;
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

/// A point is covered at every heading if no edge, turned to any of them, cuts it off: the tangents at the
/// first and the last heading, and, between them, chords of the circle that the edge turns on.
std::vector<Point> commonTo(const Footprint& footprint, double yaw_rad, double half_rad) {
  const double far = 2.0 * (footprint.margin_m + std::abs(footprint.x.min) + std::abs(footprint.x.max) +
                            std::abs(footprint.y.min) + std::abs(footprint.y.max));
  std::vector<Point> common{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  for (const auto [angle, offset] : edgesOf(footprint)) {
    for (const double turned : {-half_rad, half_rad}) {
      common = clipped(common, {angle + yaw_rad + turned, offset});
      if (offset > 0.0)
        common = clipped(common, {angle + yaw_rad + 0.5 * turned, offset * std::cos(0.5 * half_rad)});
    }
  }
  thinOut(common);
  return common;
}

/// Where the corners get to: at the first heading, at the last, and where the tangents there meet.
std::vector<Point> allOf(Range x, Range y, double yaw_rad, double half_rad) {
  std::vector<Point> all;
  for (const double px : {x.min, x.max}) {
    for (const double py : {y.min, y.max}) {
      const double radius = std::hypot(px, py);
      const double angle = std::atan2(py, px) + yaw_rad;
      const auto add = [&](double r, double turned) {
        const Point u = unit(angle + turned);
        all.push_back({r * u.x, r * u.y});
      };
      add(radius, -half_rad);
      add(radius / std::cos(half_rad), 0.0);
      add(radius, half_rad);
    }
  }
  return all;
}

double reachOf(const std::vector<Point>& points, Point direction) {
  double reach = -std::numeric_limits<double>::infinity();
  for (const Point p : points) reach = std::max(reach, dot(direction, p));
  return reach;
}

}  // namespace

double Outline::reach(Point direction) const { return reachOf(corners, direction); }

Outline outlineOf(std::vector<Point> corners) {
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point from = corners[i];
    const Point to = corners[(i + 1) % corners.size()];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0.0)) continue;
    const Point normal{(to.y - from.y) / length, (from.x - to.x) / length};
    outline.normals.push_back(normal);
    // Not the edge's own distance: of an edge that rounding has turned, all the outline must stay inside.
    outline.offsets.push_back(reachOf(corners, normal));
  }
  outline.corners = std::move(corners);
  return outline;
}

Core coreOf(const Footprint& footprint, double yaw_rad, double half_rad) {
  static constexpr std::array<Point, 4> kDirections{Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}};
  Core core;
  core.common = outlineOf(commonTo(footprint, yaw_rad, half_rad));
  core.middle = commonTo(footprint, yaw_rad, 0.0);
  core.all =
      allOf(footprint.x.grown(footprint.margin_m), footprint.y.grown(footprint.margin_m), yaw_rad, half_rad);
  for (const Point p : core.all) core.radius_m = std::max(core.radius_m, std::hypot(p.x, p.y));
  const std::vector<Point> bare = commonTo({footprint.x, footprint.y, 0.0}, yaw_rad, half_rad);
  const std::vector<Point> bare_all = allOf(footprint.x, footprint.y, yaw_rad, half_rad);
  for (std::size_t i = 0; i < 4; ++i) {
    core.least[i] = reachOf(bare, kDirections[i]);
    core.most[i] = reachOf(bare_all, kDirections[i]);
  }
  return core;
}

}  // namespace underway::proof
