#pragma once

#include <string>

#include "tests/judge/course.hpp"
#include "tests/judge/document.hpp"
#include "tests/judge/robot_file.hpp"

namespace judge {

/// Samples of a way lie no further apart than this [m].
inline constexpr double kSample_m = 1e-3;

/// A segment's body on its way, and the slab it sees.
struct Passage {
  Course course;
  Course widened;  ///< by the mode's drift over the whole length, to both sides of the motion
  double z_min = 0.0;
  double z_max = 0.0;
};

/// The mode and the motion must be known to the robot.
Passage passageOf(const Segment& segment, const Scene& scene, const RobotFile& robot);

/// A body standing still.
Passage standing(const Pose& pose, const std::string& mode, const Scene& scene, const RobotFile& robot);

}  // namespace judge
