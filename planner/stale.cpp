#include "planner/stale.hpp"

#include <algorithm>

#include "planner/roadmap.hpp"

namespace underway {

std::optional<std::size_t> firstBroken(const Plan& plan, const Checker& checker, std::size_t from_segment) {
  if (plan.segments.empty()) return std::nullopt;
  const Motion& first = plan.segments.front().motion;
  const Motion& last = plan.segments.back().motion;
  const double start_m = clearanceToKeep(checker, first.mode, first.from);
  const double goal_m = clearanceToKeep(checker, last.to_mode, last.to);
  for (std::size_t i = from_segment; i < plan.segments.size(); ++i) {
    const Motion& motion = plan.segments[i].motion;
    double keep_m = checker.robot().margin_m;
    if (motion.from.position() == first.from.position()) keep_m = std::min(keep_m, start_m);
    if (motion.to.position() == last.to.position()) keep_m = std::min(keep_m, goal_m);
    if (!isFreeKeeping(checker, motion, keep_m)) return i;
  }
  return std::nullopt;
}

}  // namespace underway
