#pragma once

#include "geometry/checker.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

/// The clearance that each motion of a plan keeps: the margin, or what start or goal have themselves if that
/// is less, on the motions that leave the one or come to the other.
class Keep {
 public:
  /// `margin_m` may be more than the robot's own.
  Keep(const Checker& checker, const Request& request, double margin_m);

  /// Without start and goal.
  Keep(const Checker& checker, double margin_m);

  [[nodiscard]] double of(const Motion& motion) const;
  [[nodiscard]] bool isFree(const Motion& motion) const { return checker_->isFree(motion, of(motion)); }
  [[nodiscard]] double margin() const { return margin_m_; }

 private:
  const Checker* checker_;
  double margin_m_;
  Point start_;
  double start_m_;
  Point goal_;
  double goal_m_;
};

}  // namespace underway::bench
