#pragma once

namespace underway {

/// GODZILA's parameters: those of the thesis' Table 7 under its names, and what its text leaves open (Brooks
/// 2017, chapters 3.3 and 5.1.3). The defaults are our tuned preset.
struct GodzilaSettings {
  // Thresholds.
  double goal_stopping_radius_m = 0.3;  ///< nearer than this the goal is reached [m]
  double least_speed = -1.0;            ///< Minimum Linear Velocity, share of the robot's top speed
  double most_speed = 1.0;              ///< Maximum Linear Velocity, share of the robot's top speed
  double least_turn = -1.0;             ///< Minimum Angular Velocity, share of the robot's top turning speed
  double most_turn = 1.0;               ///< Maximum Angular Velocity, share of the robot's top turning speed
  double clearance_threshold_m = 0.3;   ///< costs grow steeply nearer than this, centre to obstacle [m]
  double obstacle_threshold_m = 1.2;    ///< r_c: what is further attracts [m]
  // Turning.
  double goal_attraction = 100.0;    ///< f11
  double obstacle_repulsion = 20.0;  ///< g24
  double obstacle_attraction = 4.0;  ///< g26
  double bearing_ratio = 0.5;        ///< 1: what lies ahead repels most; 0: what lies towards the goal
  double inertia = 15.0;             ///< f31
  // Forward motion.
  double velocity_gain = 5.0;
  double forward_repulsion = 1.0;  ///< Obstacle Repulsion, of the nearest obstacle on the speed
  double turn_braking = 1.0;       ///< Angular Rate Braking
  // What the text leaves open.
  double bearing_width_rad = 0.3;  ///< eps of the class-L function of bearings, 1 / (a^2 + eps^2) [rad]
  double farthest_m = 5.6;         ///< how far a beam that met nothing counts as seeing [m]
};

/// Table 7 as printed. Its speeds are shares: 0.4 and 0.2 of NAO's top speeds, not metres and radians.
[[nodiscard]] GodzilaSettings table7();
/// Ours: passes gaps and corridors of 73 cm with NAO's whole body (docs/local.md tells how it was found).
[[nodiscard]] GodzilaSettings tuned();

}  // namespace underway
