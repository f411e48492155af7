#pragma once

#include <memory>

#include "geometry/robot.hpp"
#include "geometry/world.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

/// How sure it is that no plan leads from a place to a goal.
enum class NoWay : std::uint8_t {
  kFalse,     ///< one does
  kNotFound,  ///< a minute's search with a roadmap of its own and an exhaustive one by the oracle find none
  kProven,    ///< the planner proves that there is none
};

/// Looks for a way in a world, the true one, as long as there may be one. Takes up to two minutes.
[[nodiscard]] NoWay noWay(const std::shared_ptr<const World>& world,
                          const std::shared_ptr<const Robot>& robot, Request request);

}  // namespace underway::bench
