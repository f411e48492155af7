#include "planner/stances.hpp"

#include <algorithm>
#include <cmath>

namespace underway {
namespace {

double highestSpeedOf(const Robot& robot) {
  double fastest = 0.0;
  for (const Mode& mode : robot.modes)
    for (const double speed : mode.speed_mps) fastest = std::max(fastest, speed);
  for (const Switch& change : robot.switches) {
    const double moved = std::hypot(change.displacement.x, change.displacement.y);
    if (moved > 0.0)
      fastest = std::max(fastest, moved / change.duration_s);  // infinite when it takes no time
  }
  return fastest;
}

}  // namespace

Stances::Stances(const Checker& checker, Policy policy, double at_least_m)
    : groups_(checker.robot()),
      policy_(policy),
      at_least_m_(at_least_m),
      highest_mps_(highestSpeedOf(checker.robot())) {
  for (const std::vector<ModeId>& modes : groups_.modes)
    legs_.emplace_back(checker, policy, at_least_m, modes);
}

std::size_t Stances::mostWays() const {
  std::size_t most = 1;
  for (const Legs& legs : legs_) most = std::max(most, legs.ways().size());
  return most;
}

}  // namespace underway
