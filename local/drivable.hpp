#pragma once

#include "geometry/error.hpp"
#include "geometry/robot.hpp"

namespace underway {

/// Whether the local layer can carry out plans of a robot: low modes are crawled straight ahead, in cycles
/// that the gait counts, between one change down from standing and one up. Errors: kInvalidRobot, a sentence
/// that names the mode. (Plans are made for any robot.)
[[nodiscard]] Expected<void> checkDrivable(const Robot& robot);

}  // namespace underway
