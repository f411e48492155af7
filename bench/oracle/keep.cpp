#include "bench/oracle/keep.hpp"

#include <algorithm>
#include <limits>

namespace underway::bench {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// By how much the standing body may grow, up to the margin, to 1 um.
double growthOf(const Checker& checker, ModeId mode, const Pose& pose, double margin_m) {
  if (checker.isFree(stay(mode, pose), margin_m)) return margin_m;
  double free = 0.0;
  double touching = margin_m;
  while (touching - free > 1e-6) {
    const double middle = 0.5 * (free + touching);
    (checker.isFree(stay(mode, pose), middle) ? free : touching) = middle;
  }
  return free;
}

}  // namespace

Keep::Keep(const Checker& checker, const Request& request, double margin_m)
    : checker_(&checker),
      margin_m_(margin_m),
      start_(request.start.position()),
      start_m_(growthOf(checker, request.start_mode, request.start, margin_m)),
      goal_(request.goal),
      goal_m_(request.goal_yaw ? growthOf(checker, request.goal_mode,
                                          {request.goal.x, request.goal.y, *request.goal_yaw}, margin_m)
                               : margin_m) {}

Keep::Keep(const Checker& checker, double margin_m)
    : checker_(&checker),
      margin_m_(margin_m),
      start_{kNowhere, kNowhere},
      start_m_(margin_m),
      goal_{kNowhere, kNowhere},
      goal_m_(margin_m) {}

double Keep::of(const Motion& motion) const {
  double keep = margin_m_;
  if (motion.from.position() == start_) keep = std::min(keep, start_m_);
  if (motion.to.position() == goal_) keep = std::min(keep, goal_m_);
  return keep;
}

}  // namespace underway::bench
