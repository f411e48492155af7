#pragma once

#include <memory>
#include <span>

#include "geometry/world.hpp"
#include "planner/plan.hpp"

namespace underway {

/// What was seen that the map does not have, as obstacles of a world to plan in: each point a box of a size
/// [m], as high as the robot. Points that the robot stands on, in a mode at a pose, are left out: by its own
/// belief they cannot be there.
[[nodiscard]] World withSurprises(const World& base, std::span<const Point> seen, double size_m,
                                  const Robot& robot, ModeId mode, const Pose& at);

/// Whether a plan lies down to crawl close by such obstacles: what was seen may reach further than its faces
/// that were seen, and most robots see nothing while they lie.
[[nodiscard]] bool crawlsBesideSurprises(const Plan& plan, const std::shared_ptr<const World>& world,
                                         const std::shared_ptr<const Robot>& robot);

}  // namespace underway
