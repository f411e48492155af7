#pragma once

#include "geometry/robot.hpp"

namespace underway {

/// Whether the robot lies in a mode: its body is lower than the standing one, the first mode's.
[[nodiscard]] inline bool isLow(const Robot& robot, ModeId mode) {
  return robot.modes[mode].body_m.z.max < robot.modes.front().body_m.z.max;
}

}  // namespace underway
