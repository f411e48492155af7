#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/proof/stances.hpp"

namespace underway::proof {

/// One thing that a body, or a switch's box, does not get at an obstacle.
struct Lack {
  std::size_t shape = 0;               ///< that lacks it; index into Stances::shapes
  Blocking blocking;                   ///< as errors tell it
  std::string who;                     ///< "crawl", "frontal to crawl"
  std::optional<std::size_t> partner;  ///< the obstacle on the other side of the gap
  bool is_of_switch = false;           ///< the shape is a switch's box
  bool is_beside_bounds = false;       ///< the bounds are there
  [[nodiscard]] double missing_m() const { return blocking.needs_m - blocking.has_m; }
};

/// All that may be missing at an obstacle (an index into the world's), that which is missing least first:
/// - height, if the obstacle hangs: the body's, against the obstacle's underside;
/// - width, for a body: across each way it moves, margins included, against the gap to each other obstacle,
///   or to the bounds, that is narrower than this;
/// - length, for a switch: of its box, likewise. Where its box's width or height does not fit, it is said to
/// be
///   of the switch.
/// What has no such gap leaves 0 m. A switch is told as one of the two modes: of that which comes later in
/// the robot's order. Distances are planar, as the shape sees the obstacles.
[[nodiscard]] std::vector<Lack> lacksAt(const Checker& checker, const Stances& stances, std::size_t obstacle);

/// "crawl needs 0.210 m of height, beam leaves 0.190 m";
/// "lateral needs 0.300 m of width, wall_3 and shelf leave 0.280 m".
[[nodiscard]] std::string sentenceOf(const Lack& lack, const World& world);

}  // namespace underway::proof
