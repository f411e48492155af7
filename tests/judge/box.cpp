#include <algorithm>
#include <cmath>

#include "tests/judge/scene.hpp"

namespace judge {
namespace {

Vec3 mixed(Vec3 a, Vec3 b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// The corners of each of the six faces, in order round the face.
constexpr std::array<std::array<std::size_t, 4>, 6> kFaces{
    {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};

/// The part of a face where `height` is not negative. `height` must be linear.
template <class Height>
std::vector<Vec3> clipped(const std::vector<Vec3>& face, Height height) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3 a = face[i];
    const Vec3 b = face[(i + 1) % face.size()];
    const double above_a = height(a);
    const double above_b = height(b);
    if (above_a >= 0.0) kept.push_back(a);
    if ((above_a > 0.0 && above_b < 0.0) || (above_a < 0.0 && above_b > 0.0))
      kept.push_back(mixed(a, b, above_a / (above_a - above_b)));
  }
  return kept;
}

template <class Visit>
void forEachFace(const Box& box, Visit visit) {
  const std::array<Vec3, 8> corners = cornersOf(box);
  for (const auto& face : kFaces)
    visit(std::vector<Vec3>{corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]});
}

}  // namespace

std::array<Vec3, 8> cornersOf(const Box& box) {
  const auto [cr, sr] = std::pair{std::cos(box.rpy_rad.x), std::sin(box.rpy_rad.x)};
  const auto [cp, sp] = std::pair{std::cos(box.rpy_rad.y), std::sin(box.rpy_rad.y)};
  const auto [cy, sy] = std::pair{std::cos(box.rpy_rad.z), std::sin(box.rpy_rad.z)};
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    Vec3 p{(i & 1U ? 0.5 : -0.5) * box.size_m.x, (i & 2U ? 0.5 : -0.5) * box.size_m.y,
           (i & 4U ? 0.5 : -0.5) * box.size_m.z};
    p = {p.x, cr * p.y - sr * p.z, sr * p.y + cr * p.z};
    p = {cp * p.x + sp * p.z, p.y, -sp * p.x + cp * p.z};
    p = {cy * p.x - sy * p.y, sy * p.x + cy * p.y, p.z};
    corners[i] = {box.center_m.x + p.x, box.center_m.y + p.y, box.center_m.z + p.z};
  }
  return corners;
}

Polygon footprint(const Box& box, double z_min, double z_max) {
  // What a horizontal plane cuts out of a box is bounded by the box's faces, so the clipped faces show the
  // whole.
  std::vector<Vec2> points;
  forEachFace(box, [&](std::vector<Vec3> face) {
    face = clipped(face, [&](Vec3 p) { return p.z - z_min; });
    face = clipped(face, [&](Vec3 p) { return z_max - p.z; });
    for (const Vec3 p : face) points.push_back({p.x, p.y});
  });
  return convexHull(std::move(points));
}

std::optional<double> lowestOver(const Box& box, const Polygon& area, double z_min) {
  std::optional<double> lowest;
  forEachFace(box, [&](std::vector<Vec3> face) {
    for (std::size_t i = 0; i < area.size(); ++i) {
      const Vec2 a = area[i];
      const Vec2 along = area[(i + 1) % area.size()] - a;
      face = clipped(face, [&](Vec3 p) { return cross(along, Vec2{p.x, p.y} - a); });
    }
    face = clipped(face, [&](Vec3 p) { return p.z - z_min; });
    for (const Vec3 p : face) lowest = std::min(lowest.value_or(p.z), p.z);
  });
  return lowest;
}

}  // namespace judge
