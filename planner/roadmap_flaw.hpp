#pragma once

#include <optional>
#include <string>

#include "geometry/robot.hpp"
#include "planner/roadmap.hpp"
#include "planner/stances.hpp"

namespace underway {

/// Whether a motion is one that the robot can make: modes, sense and switch are its own, numbers are finite,
/// and the end is where the motion leads from its beginning, within 1e-9 m and rad. Says nothing of the
/// world.
[[nodiscard]] bool isLegal(const Robot& robot, const Motion& motion);

/// What is wrong with the places, links, ways and crossings of a roadmap that a file says is the robot's;
/// empty when any code may walk it. Looks at form alone: whether ways are free is for repair.hpp. The motions
/// of its crossings must be legal and chained already.
[[nodiscard]] std::optional<std::string> flawIn(const Roadmap& roadmap, const Stances& stances,
                                                const Robot& robot);

}  // namespace underway
