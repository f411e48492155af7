#pragma once

#include <cstdint>
#include <memory>

#include "geometry/pose.hpp"
#include "geometry/world.hpp"

namespace underway::bench {

/// A world to drive in without a plan, from a pose to a point.
struct PureRoom {
  std::shared_ptr<const World> world;
  Pose start;
  Point goal;
};

/// The thesis' arena (11.75 x 5.5 m), halved by a wall at random with one gap of .73 m at random in it.
[[nodiscard]] PureRoom randomGap(std::uint64_t seed);
/// The same arena with a wall, 1.5 to 3 m wide, squarely between start and goal.
[[nodiscard]] PureRoom wallInFront(std::uint64_t seed);
/// The same arena with a U, .6 to 1.5 m deep and 1.2 to 2.5 m wide inside, its opening towards the start.
[[nodiscard]] PureRoom uInFront(std::uint64_t seed);

}  // namespace underway::bench
