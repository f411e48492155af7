#pragma once

#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "local/senses.hpp"
#include "sim/lidar.hpp"

namespace underway::sim {

/// How a real robot falls short of its commands and its sensors of the truth.
struct Flaws {
  double pose_sigma_m = 0.015;             ///< of the pose that is told, each axis [m]
  double pose_sigma_rad = 0.01745;         ///< [rad]
  int late_ticks = 1;                      ///< how old the pose is
  double stroke_lost = 0.13;               ///< share of a crawl's stroke that slips, mean
  double stroke_sigma = 0.05;              ///< of each cycle's share
  double drift_rad_per_m = 0.0349;         ///< heading drift while moving, mean of its size; either side
  double drift_sigma_rad_per_m = 0.01745;  ///< of its size, from run to run
  double lidar_scale = 1.0;                ///< times the lidar's sigma

  /// All noise times a factor; the mean of the lost stroke is no noise and stays.
  [[nodiscard]] Flaws times(double factor) const;
};

/// What a robot does and where it truly is: what its sensors go by.
struct Bearing {
  double now_s = 0.0;
  Pose pose;                 ///< of the body frame, in the map frame
  bool is_upright = true;    ///< the lidar at its waist and its depth camera see
  bool can_localise = true;  ///< if a lidar sees
  double heading_rad = 0.0;  ///< the inertial one, without noise
};

/// The lidars, the depth camera, the localisation and the inertial heading of a simulated robot, each with
/// its noise. Which it has is for the robot file to say. Scans are kept until the next call.
class Sensors {
 public:
  static constexpr double kTick_s = 0.1;

  Sensors(const World& truth, std::shared_ptr<const Robot> robot, const Flaws& flaws, const Pose& start);

  /// Fills in scan, depth, pose, heading and time.
  void sense(const Bearing& bearing, Senses& senses, std::mt19937_64& random);
  /// A tick has gone by, the robot is here now: localisation tells it late.
  void remember(const Pose& pose);
  /// Where the head, and the depth camera on it, turns to, from the body's front [rad].
  void look(double rad);

 private:
  std::shared_ptr<const Robot> robot_;
  Flaws flaws_;
  std::optional<Lidar> waist_;
  std::optional<Lidar> head_;
  std::optional<Lidar> depth_;
  std::vector<Pose> past_;  // true poses, the newest last, as many as the pose is late
  double look_rad_ = 0.0;
  Scan scan_;
  Scan depth_scan_;
};

}  // namespace underway::sim
