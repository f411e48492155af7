#pragma once

#include <memory>
#include <random>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/convex.hpp"
#include "geometry/world.hpp"
#include "local/scan.hpp"

namespace underway::sim {

/// A planar range sensor; the defaults are the URG-04LX at NAO's waist. Ranges beyond `farthest_m` and below
/// `nearest_m` are told as nothing.
struct LidarSettings {
  Beams beams;
  Range heights_m{0.30, 0.30};  ///< above the floor: one plane; a depth camera sees a slab, as if from above
  double nearest_m = 0.02;      ///< [m]
  double farthest_m = 5.6;      ///< [m]
  double sigma_m = 0.010;       ///< of ranges below 1 m [m]
  double sigma_share = 0.01;    ///< of ranges above 1 m
};

/// A simulated lidar in the true world. It sees what crosses its heights and nothing else: a table top above
/// its plane is not there for it. Rays are cut with the obstacles' outlines exactly; then noise is added.
class Lidar {
 public:
  Lidar(const World& world, const LidarSettings& settings);

  /// The scan from the body frame's true pose, without noise.
  void look(const Pose& from, Scan& scan) const;
  /// The same with noise.
  void look(const Pose& from, Scan& scan, std::mt19937_64& random) const;

  [[nodiscard]] const LidarSettings& settings() const { return settings_; }

 private:
  void cast(const std::vector<Point>& outline, const Pose& from, Scan& scan) const;
  void castEdge(Point a, Point b, Scan& scan) const;

  LidarSettings settings_;
  std::vector<Point> directions_;  // of the beams
  std::vector<std::vector<Point>> outlines_;
};

}  // namespace underway::sim
