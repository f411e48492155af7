#include "geometry/flatten.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "geometry/rectangle.hpp"

namespace underway {
namespace {

// Corners are numbered as corners() says: bit 0 is x, bit 1 is y, bit 2 is z.
constexpr std::array<std::array<unsigned, 2>, 12> kEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<std::array<unsigned, 4>, 6> kFaces{
    {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};

Vec3 between(const Vec3& a, const Vec3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// The part of a polygon in space where a plane's value is not negative (Sutherland and Hodgman).
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const std::function<double(const Vec3&)>& value) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    const double va = value(a);
    const double vb = value(b);
    if (va >= 0.0) kept.push_back(a);
    if ((va < 0.0) != (vb < 0.0)) kept.push_back(between(a, b, va / (va - vb)));
  }
  return kept;
}

}  // namespace

bool isUpright(const OrientedBox& box) { return box.rpy_rad.x == 0.0 && box.rpy_rad.y == 0.0; }

bool reachesInto(const OrientedBox& upright, Range slab) {
  const double half = 0.5 * upright.size_m.z;
  return upright.center_m.z - half <= slab.max && upright.center_m.z + half >= slab.min;
}

std::vector<Point> flattened(const OrientedBox& box, Range slab) {
  if (isUpright(box)) {
    if (!reachesInto(box, slab)) return {};
    const auto corners = cornersOf(footprintOf(box));
    return {corners.begin(), corners.end()};
  }
  const std::array<Vec3, 8> vertices = corners(box);
  std::vector<Point> shadow;
  for (const Vec3& v : vertices)
    if (v.z >= slab.min && v.z <= slab.max) shadow.push_back({v.x, v.y});
  for (const auto& [from, to] : kEdges) {
    const Vec3& a = vertices[from];
    const Vec3& b = vertices[to];
    for (const double z : {slab.min, slab.max}) {
      if ((a.z < z) == (b.z < z)) continue;
      const Vec3 cut = between(a, b, (z - a.z) / (b.z - a.z));
      shadow.push_back({cut.x, cut.y});
    }
  }
  return convexHull(std::move(shadow));
}

std::optional<double> lowestAbove(const OrientedBox& box, ConvexView area, double height_m) {
  const std::array<Vec3, 8> vertices = corners(box);
  const auto below = [&](const Vec3& v) { return v.z < height_m; };
  if (std::all_of(vertices.begin(), vertices.end(), below)) return std::nullopt;
  if (isUpright(box)) {
    const std::vector<Point> shadow = flattened(box, {height_m, vertices[7].z});
    if (shadow.empty() || gapBetween(area, shadow).distance_m > 0.0) return std::nullopt;
    return std::max(vertices[0].z, height_m);
  }
  std::optional<double> lowest;
  for (const auto& face : kFaces) {
    std::vector<Vec3> polygon{vertices[face[0]], vertices[face[1]], vertices[face[2]], vertices[face[3]]};
    polygon = clipped(polygon, [&](const Vec3& v) { return v.z - height_m; });
    for (std::size_t i = 0; i < area.size() && !polygon.empty(); ++i) {
      const Point a = area[i];
      const Point b = area[(i + 1) % area.size()];
      polygon = clipped(polygon,
                        [&](const Vec3& v) { return (b.x - a.x) * (v.y - a.y) - (b.y - a.y) * (v.x - a.x); });
    }
    for (const Vec3& v : polygon) lowest = std::min(lowest.value_or(v.z), v.z);
  }
  return lowest;
}

}  // namespace underway
