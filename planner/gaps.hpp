#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "geometry/world.hpp"

namespace underway {

/// Finds gaps between obstacles, and between them and the bounds: drawing poses at random rarely hits a
/// narrow passage, looking across from a face of an obstacle to what stands opposite does, and so does
/// looking from one obstacle to the nearest point of another, where only their corners make it narrow. Tilted
/// boxes are left out; sampling finds their gaps.
class Gaps {
 public:
  /// A gap's middle, and the direction across it [rad].
  struct Gap {
    Point middle;
    double across_rad = 0.0;
    double width_m = 0.0;
  };

  /// Between obstacles that reach into a slab of heights [m], up to a width.
  Gaps(const World& world, Range slab, double widest_m);

  /// From a random obstacle to what lies opposite a random point of its outline, or, once in three times, to
  /// the nearest point of a random neighbour; none if nothing does, or it touches.
  [[nodiscard]] std::optional<Gap> draw(std::mt19937_64& random) const;

 private:
  struct Footprint {
    Pose frame;  ///< middle and direction
    double half_x;
    double half_y;
    double cos;  ///< of the direction
    double sin;
  };
  /// From a point of an outline, away from it.
  struct Look {
    Point from;
    double normal_rad = 0.0;
  };
  void add(const Pose& frame, double half_x, double half_y);
  void addBounds(const Bounds& bounds);
  [[nodiscard]] static Look lookFrom(const Footprint& footprint, std::mt19937_64& random);
  [[nodiscard]] std::optional<Gap> opposite(std::size_t own, const Look& look,
                                            const std::vector<std::uint32_t>& near) const;
  [[nodiscard]] std::optional<Gap> betweenNearest(std::size_t own, std::size_t other) const;
  [[nodiscard]] static Point nearestOn(const Footprint& footprint, Point to);
  [[nodiscard]] static Point pointIn(const Pose& frame, double x, double y);
  [[nodiscard]] bool isOver(Point point) const;
  [[nodiscard]] std::size_t cellAt(Point point) const;
  /// Along a direction of length 1, to where a footprint begins; infinite where it is not met.
  [[nodiscard]] static double wayTo(const Footprint& footprint, Point from, Point direction);

  double widest_m_;
  Pose corner_;  // of the bucket grid, over the bounds
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<Footprint> footprints_;  // of the obstacles, then the bounds
  std::size_t obstacle_count_ = 0;
  std::vector<std::vector<std::uint32_t>>
      cells_;  // footprints within the widest gap of each cell, of that size
};

}  // namespace underway
