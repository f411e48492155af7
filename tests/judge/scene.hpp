#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/judge/image.hpp"
#include "tests/judge/plane.hpp"

namespace judge {

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// An oriented box, R = Rz(yaw) Ry(pitch) Rx(roll), and the id it is known by. A map's occupied cells have no
/// id.
struct Box {
  std::string id;
  Vec3 center_m;
  Vec3 size_m;
  Vec3 rpy_rad;
};

/// Corner i has the sign of bit 0 in x, bit 1 in y, bit 2 in z.
std::array<Vec3, 8> cornersOf(const Box& box);

/// What of a box lies between two heights, seen from above; empty if nothing does. Touching a height counts.
Polygon footprint(const Box& box, double z_min, double z_max);

/// The lowest height [m] above `z_min` at which the box hangs over a convex area; empty if it does not.
std::optional<double> lowestOver(const Box& box, const Polygon& area, double z_min);

/// A map as a plan file is judged by.
struct Scene {
  std::string name;
  double floor_z_m = 0.0;
  Polygon bounds;  ///< the whole body stays inside
  std::vector<Box> boxes;
};

enum class Unknown { kOccupied, kFree };

/// Reads a scenario YAML or a ROS map_server YAML (trinary) with its image. Throws InputError.
Scene readScene(const std::filesystem::path& file, Unknown unknown = Unknown::kOccupied);

}  // namespace judge
