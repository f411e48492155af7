#pragma once

#include "geometry/box.hpp"
#include "geometry/pose.hpp"
#include "sim/physics/scene.hpp"

namespace underway::physics {

/// The box that encloses all of the robot's contact shapes, in a body frame on the ground [m]. Exact for
/// spheres, capsules and boxes, the shapes a robot may have.
[[nodiscard]] BodyBox enclose(const mjModel_& model, const mjData_& data, const Pose& frame);

}  // namespace underway::physics
