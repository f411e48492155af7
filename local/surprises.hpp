#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/world.hpp"
#include "planner/plan.hpp"

namespace underway {

/// How much more than points what was seen is taken for.
struct Caution {
  double size_m = 0.06;      ///< of a point [m]
  bool extends_ends = true;  ///< where a row of points ends, 10 cm more: the rest may not have been seen yet
};

/// What was seen that the map does not have, as obstacles of a world to plan in: each point a box, as high as
/// the robot. Points that the robot stands on, in a mode at a pose, are left out: by its own belief they
/// cannot be there.
[[nodiscard]] World withSurprises(const World& base, std::span<const Point> seen, const Caution& caution,
                                  const Robot& robot, ModeId mode, const Pose& at);

/// The same world with floor that was not seen as obstacles, so that plans keep off it: `unseen` are the
/// middles of SeenFloor's cells, of which rows become one. Where the robot stands, and a margin round it, is
/// left out.
[[nodiscard]] World withUnseenFloor(const World& base, std::span<const Point> unseen, const Robot& robot,
                                    ModeId mode, const Pose& at);

/// Such obstacles that a plan lies down to crawl close by, by their ids: what was seen may reach further than
/// its faces that were seen, and most robots see nothing while they lie.
[[nodiscard]] std::vector<std::string> surprisesBesideCrawl(const Plan& plan,
                                                            const std::shared_ptr<const World>& world,
                                                            const std::shared_ptr<const Robot>& robot);

/// The same world with some of them so much larger that a plan in it crawls close by none of these. Ids that
/// the world does not have are passed over.
[[nodiscard]] World withBerth(const World& world, std::span<const std::string> ids);

}  // namespace underway
