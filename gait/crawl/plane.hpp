#pragma once

#include <cmath>

namespace underway::gait {

/// A point or a vector in the sagittal plane: x the way the robot crawls, z up [m].
struct PlanePoint {
  double x = 0.0;
  double z = 0.0;
  bool operator==(const PlanePoint&) const = default;
};

[[nodiscard]] inline PlanePoint operator+(PlanePoint a, PlanePoint b) { return {a.x + b.x, a.z + b.z}; }
[[nodiscard]] inline PlanePoint operator-(PlanePoint a, PlanePoint b) { return {a.x - b.x, a.z - b.z}; }
[[nodiscard]] inline double length(PlanePoint v) { return std::hypot(v.x, v.z); }
/// A vector of that length at an angle counter-clockwise from x [rad].
[[nodiscard]] inline PlanePoint along(double length_m, double angle_rad) {
  return {length_m * std::cos(angle_rad), length_m * std::sin(angle_rad)};
}

[[nodiscard]] constexpr double radians(double degrees) { return degrees * 0.017453292519943295; }
[[nodiscard]] constexpr double degrees(double radians) { return radians * 57.29577951308232; }

}  // namespace underway::gait
