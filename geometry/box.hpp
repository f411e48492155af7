#pragma once

#include <array>

namespace underway {

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  bool operator==(const Vec3&) const = default;
};

/// Rows of a rotation matrix.
using Rotation = std::array<Vec3, 3>;

/// A box anywhere in the map frame. size is the full size; R = Rz(yaw) Ry(pitch) Rx(roll).
struct OrientedBox {
  Vec3 center_m;
  Vec3 size_m;
  Vec3 rpy_rad;  ///< roll, pitch, yaw
  bool operator==(const OrientedBox&) const = default;
};

[[nodiscard]] Rotation rotation(const OrientedBox& box);

/// The eight corners, in the map frame [m]. Corner i has the sign of bit 0 in x, bit 1 in y, bit 2 in z.
[[nodiscard]] std::array<Vec3, 8> corners(const OrientedBox& box);

/// A closed range, min <= max.
struct Range {
  double min = 0.0;
  double max = 0.0;
  [[nodiscard]] double length() const { return max - min; }
  [[nodiscard]] Range grown(double by) const { return {min - by, max + by}; }
  bool operator==(const Range&) const = default;
};

/// The smallest range that holds both.
[[nodiscard]] Range hull(Range a, Range b);

/// The box that encloses the robot in a mode, as ranges in the body frame [m]: x forward, y left, z up from
/// the floor.
struct BodyBox {
  Range x;
  Range y;
  Range z;
  bool operator==(const BodyBox&) const = default;
};

}  // namespace underway
