#include "planner/cost.hpp"

#include <cmath>

namespace underway {

Cost costOf(const Robot& robot, Policy policy, const Motion& motion) {
  const Cost time = Cost::time(1 + static_cast<std::uint64_t>(std::ceil(duration(robot, motion) * 1e6)));
  if (policy != Policy::kPriority || motion.kind != MotionKind::kTranslate) return time;
  return time + Cost::distance(motion.mode, static_cast<std::uint32_t>(std::llround(length(motion) * 1e3)));
}

}  // namespace underway
