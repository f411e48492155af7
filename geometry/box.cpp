#include "geometry/box.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

Rotation rotation(const OrientedBox& box) {
  const double cr = std::cos(box.rpy_rad.x), sr = std::sin(box.rpy_rad.x);
  const double cp = std::cos(box.rpy_rad.y), sp = std::sin(box.rpy_rad.y);
  const double cy = std::cos(box.rpy_rad.z), sy = std::sin(box.rpy_rad.z);
  return {Vec3{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
          Vec3{sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr}, Vec3{-sp, cp * sr, cp * cr}};
}

std::array<Vec3, 8> corners(const OrientedBox& box) {
  const Rotation rows = rotation(box);
  std::array<Vec3, 8> result;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 local{(i & 1U ? 0.5 : -0.5) * box.size_m.x, (i & 2U ? 0.5 : -0.5) * box.size_m.y,
                     (i & 4U ? 0.5 : -0.5) * box.size_m.z};
    const auto along = [&](const Vec3& row) { return row.x * local.x + row.y * local.y + row.z * local.z; };
    result[i] = {box.center_m.x + along(rows[0]), box.center_m.y + along(rows[1]),
                 box.center_m.z + along(rows[2])};
  }
  return result;
}

Range hull(Range a, Range b) { return {std::min(a.min, b.min), std::max(a.max, b.max)}; }

}  // namespace underway
