#pragma once

#include "tests/judge/document.hpp"
#include "tests/judge/judge.hpp"

namespace judge {

/// Judges where the bodies go: inside the bounds, free with the margin (a drifting mode widened to both sides
/// by its drift over the whole length), and what is claimed of clearance, nearest obstacle and headroom. The
/// motions must have passed judgeKinematics.
void judgeRoom(const Document& document, const Scene& scene, const RobotFile& robot, Verdict& verdict);

/// Judges a plan file that says 'no': a reason, no segments, and true words about start and goal.
void judgeRefusal(const Document& document, const Scene& scene, const RobotFile& robot, Verdict& verdict);

}  // namespace judge
