#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/pose.hpp"

namespace underway::physics {

/// The robot at one instant, in the frame of the ground.
struct Sample {
  double time_s = 0.0;     ///< since the recording began [s]
  Pose standing;           ///< below the middle of the ankles, heading where the left side says
  Pose lying;              ///< below the middle of the hips
  double pitch_rad = 0.0;  ///< of the torso: 0 upright, pi/2 face down [rad]
  double roll_rad = 0.0;   ///< of the torso: its left side up [rad]
  double hip_height_m = 0.0;
  BodyBox box;                     ///< encloses the robot, in the recording's frame [m]
  std::vector<double> positions;   ///< the simulator's own, to draw from
  std::vector<double> torques_nm;  ///< by servo
};

/// What a servo had to do.
struct Effort {
  double square_nm2s = 0.0;  ///< integral of the torque's square [N^2 m^2 s]
  double peak_nm = 0.0;
  double saturated_s = 0.0;  ///< time at its limit [s]
};

/// All that was seen while the robot moved.
struct Recording {
  Pose frame;  ///< the frame boxes are told in: the body frame when the motion began
  std::vector<Sample> samples;
  double duration_s = 0.0;
  std::map<std::string, Effort> efforts;  ///< by servo
  std::map<std::string, double>
      slips_m;                         ///< by shape: how far it slid on the ground while it bore weight [m]
  std::set<std::string> touches;       ///< "shape on obstacle 1": what touched anything but the ground
  std::set<std::string> self_touches;  ///< "LForeArm on head"
};

/// The box that encloses the robot in all samples, in the recording's frame [m].
[[nodiscard]] BodyBox sweptBox(const Recording& recording);

/// Weighted integral of the squared torques of a servo and its mate on the other side, averaged over the two,
/// as the paper sums them: ankle, knee, hip, shoulder [N^2 m^2 s].
[[nodiscard]] double torqueCost(const Recording& recording, const std::vector<double>& weights);

/// `to`, told in the frame of `from`.
[[nodiscard]] Pose relative(const Pose& from, const Pose& to);

}  // namespace underway::physics
