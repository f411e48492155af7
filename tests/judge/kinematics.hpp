#pragma once

#include "tests/judge/document.hpp"
#include "tests/judge/judge.hpp"

namespace judge {

/// Judges what can be judged without looking at obstacles: names, the chain of poses and modes from start to
/// goal, motions the robot has, durations and totals.
void judgeKinematics(const Document& document, const Scene& scene, const RobotFile& robot, Verdict& verdict);

}  // namespace judge
