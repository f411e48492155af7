#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "geometry/motion.hpp"
#include "geometry/sweep.hpp"
#include "geometry/world.hpp"

namespace underway::bench {

/// Draws obstacles, bodies and motions that are hard to judge. The same seed draws the same on any machine.
class RandomGeometry {
 public:
  explicit RandomGeometry(std::uint64_t seed) : random_(seed) {}

  [[nodiscard]] double between(double low, double high);
  [[nodiscard]] std::size_t oneOf(std::size_t count);
  [[nodiscard]] double angle() { return between(-3.2, 3.2); }

  /// Plain, tilted, thin, tiny or huge, about a place.
  [[nodiscard]] OrientedBox box(Point about);
  [[nodiscard]] std::vector<Obstacle> obstacles(Point about, std::size_t count);
  /// None, or some hundred, further from a place than bodies there reach, up to kilometres.
  [[nodiscard]] std::vector<Obstacle> farObstacles(Point about);
  /// About as large as a robot, or much smaller or larger, seen in a slab.
  [[nodiscard]] Prism body(Point about, Range slab);
  /// In a square about a place.
  [[nodiscard]] Pose pose(Point about);
  [[nodiscard]] Motion motion(Point about, const Robot& robot);
  /// Mostly the origin, sometimes kilometres away.
  [[nodiscard]] Point somewhere();
  /// How far to move a body so that it is within nanometres to micrometres of touching a shadow, on either
  /// side.
  [[nodiscard]] Point toContact(const std::vector<Point>& footprint, const std::vector<Point>& shadow);

 private:
  std::mt19937_64 random_;
};

/// A robot with three modes and switches, one of them drifting and longer than wide.
[[nodiscard]] std::shared_ptr<const Robot> benchRobot();

}  // namespace underway::bench
