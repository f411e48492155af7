#pragma once

#include <cstdint>
#include <optional>

#include "geometry/pose.hpp"
#include "geometry/robot.hpp"
#include "local/scan.hpp"

namespace underway {

/// The beams that a depth camera's picture is told as: nearest of all heights, by bearing.
[[nodiscard]] inline Beams depthBeamsOf(double field_rad) {
  constexpr std::size_t kCount = 257;
  return {kCount, -0.5 * field_rad, field_rad / (kCount - 1.0)};
}

/// A pose that some localisation found, and when it was so.
struct PoseEstimate {
  double stamp_s = 0.0;  ///< of the moment it is the pose of [s]
  Pose pose;             ///< in the map frame
};

/// What the robot's senses tell in one tick. Pointers are valid during the tick; null and empty mean that the
/// sense tells nothing now: lying, a lidar at the waist sees nothing, and nothing is localised by it.
struct Senses {
  double now_s = 0.0;
  const Scan* scan = nullptr;         ///< the planar lidar
  const Scan* depth = nullptr;        ///< nearest of all heights up to the standing body's top
  std::optional<PoseEstimate> pose;   ///< localisation
  std::optional<double> heading_rad;  ///< inertial, in the map frame; also while lying
  ModeId mode = 0;                    ///< the gait's own word
  bool is_switching = false;          ///< between two modes
  std::uint64_t cycles = 0;           ///< crawl cycles that the joints have completed since the start
  bool has_fallen = false;
};

}  // namespace underway
