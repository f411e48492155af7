#pragma once

#include <vector>

#include "geometry/checker.hpp"
#include "planner/cost.hpp"

namespace underway {

/// Motions from start to goal, each beginning where the last one ended, bit for bit.
using Route = std::vector<Motion>;

/// The same movement in fewer motions: turns that follow each other become one, and so do translations in
/// line. Where drift makes the joint sweep wider, only if that is free.
[[nodiscard]] Route joined(const Checker& checker, const Route& route);

[[nodiscard]] Cost costOf(const Robot& robot, Policy policy, const Route& route);

}  // namespace underway
