#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/judge/robot_file.hpp"
#include "tests/judge/scene.hpp"

namespace judge {

/// What the judge has to say about a plan file.
struct Verdict {
  std::vector<std::string> violations;  ///< one sentence each; none: the plan is sound
  std::vector<std::string> notes;       ///< readings of the format the plan relies on
  [[nodiscard]] bool isSound() const { return violations.empty(); }
};

/// Judges a plan file, segment by segment, by every sentence of the format: first its keys and types; then
/// its motions (kinematics.hpp); then, sampled at 1 mm and 0.2 degrees or finer, the room it has (room.hpp).
/// A file that says 'no' is judged by its form, and by what it says of its start and goal.
Verdict judgePlan(std::string_view plan, const Scene& scene, const RobotFile& robot);

}  // namespace judge
