#include "planner/route.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace underway {
namespace {

/// One turn in place of two; the angle is the headings' difference, exactly, plus whole revolutions.
Motion jointTurn(const Motion& first, const Motion& second) {
  constexpr double kRevolution = 2.0 * std::numbers::pi;
  const double sum = first.angle_rad + second.angle_rad;
  const double direct = normalizedAngle(second.to.yaw - first.from.yaw);
  const double angle = direct + kRevolution * std::round((sum - direct) / kRevolution);
  return turn(first.mode, first.from, angle, second.to.yaw);
}

std::optional<Motion> joint(const Checker& checker, const Motion& first, const Motion& second) {
  if (first.kind != second.kind || first.mode != second.mode) return std::nullopt;
  if (first.kind == MotionKind::kTurn) return jointTurn(first, second);
  if (first.kind != MotionKind::kTranslate || first.sense != second.sense) return std::nullopt;
  const Motion both = translate(first.mode, first.sense, first.from, second.to.position());
  if (checker.robot().modes[first.mode].drift_m_per_m > 0.0 && !checker.isFree(both)) return std::nullopt;
  return both;
}

bool isNothing(const Motion& motion) {
  return motion.kind != MotionKind::kSwitch && motion.from == motion.to && motion.angle_rad == 0.0;
}

}  // namespace

Route joined(const Checker& checker, const Route& route) {
  Route result;
  for (const Motion& motion : route) {
    const auto both = result.empty() ? std::nullopt : joint(checker, result.back(), motion);
    if (both)
      result.back() = *both;
    else
      result.push_back(motion);
    if (isNothing(result.back())) result.pop_back();
  }
  return result;
}

Cost costOf(const Robot& robot, Policy policy, const Route& route) {
  Cost sum;
  for (const Motion& motion : route) sum = sum + costOf(robot, policy, motion);
  return sum;
}

}  // namespace underway
