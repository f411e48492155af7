#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/error.hpp"
#include "geometry/obstacles.hpp"
#include "geometry/pose.hpp"

namespace underway {

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

/// The obstacles in memory. A value that does not change: share it between threads as it is. A change makes
/// another world, with the next revision, that shares with this one all that did not change.
class World {
 public:
  /// Refuses, as kInvalidMap and with the obstacle's id: sizes that are not positive, numbers that are not
  /// finite or beyond kLargest_m, ids given twice, bounds without an inside. The obstacles are sorted by id:
  /// of whatever order they are given in, the same comes of them.
  [[nodiscard]] static Expected<World> make(std::string name, Bounds bounds, double floor_z_m,
                                            std::vector<Obstacle> obstacles);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] double floorZ() const { return floor_z_m_; }  ///< where the robot stands [m]
  [[nodiscard]] const Obstacles& obstacles() const { return obstacles_; }
  /// Rises with every change; 1 when made.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// 16 hex digits over bounds, floor and obstacles, whatever their order and the changes that led here.
  [[nodiscard]] std::string hash() const;

  /// The next revision: with one obstacle more, with an obstacle elsewhere, with one less. Errors:
  /// kInvalidMap with the id, for what `make` refuses, an id that is taken, an id that is not there.
  [[nodiscard]] Expected<World> added(Obstacle obstacle) const;
  [[nodiscard]] Expected<World> moved(std::string_view id, const OrientedBox& box) const;
  [[nodiscard]] Expected<World> removed(std::string_view id) const;

  static constexpr double kLargest_m = 1e5;  ///< coordinates and sizes beyond this are refused [m]

 private:
  World() = default;
  /// This world with other obstacles and the next revision; the fingerprints are of what went and what came.
  [[nodiscard]] World next(Obstacles obstacles, std::uint64_t gone, std::uint64_t come) const;

  std::string name_;
  Bounds bounds_;
  double floor_z_m_ = 0.0;
  Obstacles obstacles_;
  std::uint64_t fingerprint_ = 0;  // sum of the obstacles' own, so that order does not matter
  std::uint64_t revision_ = 1;
};

}  // namespace underway
