#include "planner/cost.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

Cost costOf(const Robot& robot, Policy policy, const Motion& motion) {
  // Of what fits no field the most that fits: such a motion is the last choice, and no other field is
  // touched.
  constexpr double kMost_us = 1e11;
  constexpr double kMost_mm = 4e6;
  const Cost time = Cost::time(
      1 + static_cast<std::uint64_t>(std::ceil(std::min(duration(robot, motion) * 1e6, kMost_us))));
  if (policy != Policy::kPriority || motion.kind != MotionKind::kTranslate) return time;
  return time + Cost::distance(motion.mode, static_cast<std::uint32_t>(
                                                std::llround(std::min(length(motion) * 1e3, kMost_mm))));
}

}  // namespace underway
