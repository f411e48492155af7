#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/error.hpp"
#include "geometry/pose.hpp"

namespace underway {

/// Something solid, with an id that stays the same through changes of the world.
struct Obstacle {
  std::string id;
  OrientedBox box;
  bool operator==(const Obstacle&) const = default;
};

/// The rectangle the whole body stays in, in every mode: `corner` is its lower left corner, its x axis along
/// the width.
struct Bounds {
  Pose corner;            ///< in the map frame
  double width_m = 0.0;   ///< along the corner's x axis
  double height_m = 0.0;  ///< along the corner's y axis
  bool operator==(const Bounds&) const = default;

  /// Whether a point of the map frame lies inside or on the edge, but for rounding.
  [[nodiscard]] bool contains(Point point) const;
  /// Whether all of an arc lies inside: of a circle, from one direction [rad] over a signed angle [rad].
  [[nodiscard]] bool containsArc(Point center, double radius_m, double from_rad, double angle_rad) const;
  /// The corners, counter-clockwise from `corner`.
  [[nodiscard]] std::array<Point, 4> corners() const;
};

/// The obstacles in memory. A value that does not change: share it between threads as it is.
class World {
 public:
  /// Refuses, as kInvalidMap and with the obstacle's id: sizes that are not positive, numbers that are not
  /// finite or beyond kLargest_m, ids given twice, bounds without an inside.
  [[nodiscard]] static Expected<World> make(std::string name, Bounds bounds, double floor_z_m,
                                            std::vector<Obstacle> obstacles);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] double floorZ() const { return floor_z_m_; }  ///< where the robot stands [m]
  [[nodiscard]] const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  [[nodiscard]] std::uint64_t revision() const {
    return revision_;
  }  ///< rises with every change; 1 when made
  /// 16 hex digits over bounds, floor and obstacles.
  [[nodiscard]] std::string hash() const;

  static constexpr double kLargest_m = 1e5;  ///< coordinates and sizes beyond this are refused [m]

 private:
  World() = default;
  std::string name_;
  Bounds bounds_;
  double floor_z_m_ = 0.0;
  std::vector<Obstacle> obstacles_;
  std::uint64_t revision_ = 1;
};

}  // namespace underway
