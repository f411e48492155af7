#pragma once

#include <algorithm>

#include "planner/cost.hpp"
#include "planner/route.hpp"

namespace underway {

/// Motions between two stances that no choice of headings can change: a switch that moves the robot, or a
/// straight way in a mode that cannot turn, with the switches before and after it.
struct Crossing {
  Route motions;  ///< chained; at least one
  Cost cost_of_time;
  Cost cost_by_priority;

  Crossing(const Robot& robot, Route of)
      : motions(std::move(of)),
        cost_of_time(costOf(robot, Policy::kFastest, motions)),
        cost_by_priority(costOf(robot, Policy::kPriority, motions)) {}

  [[nodiscard]] const Pose& entry() const { return motions.front().from; }
  [[nodiscard]] const Pose& exit() const { return motions.back().to; }
  [[nodiscard]] ModeId entryMode() const { return motions.front().mode; }
  [[nodiscard]] ModeId exitMode() const { return motions.back().to_mode; }
  [[nodiscard]] bool isFree(const Checker& checker) const {
    return std::all_of(motions.begin(), motions.end(),
                       [&](const Motion& motion) { return checker.isFree(motion); });
  }
  [[nodiscard]] Cost cost(Policy policy) const {
    return policy == Policy::kPriority ? cost_by_priority : cost_of_time;
  }
};

}  // namespace underway
