#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "geometry/map.hpp"
#include "planner/grow.hpp"
#include "planner/planner.hpp"

namespace underway::test {

inline std::shared_ptr<const Robot> nao() {
  static const auto robot = std::make_shared<const Robot>(*readRobot(UNDERWAY_SOURCE_DIR "/robots/nao.yaml"));
  return robot;
}

/// One of our maps, by name.
inline std::shared_ptr<const World> ourWorld(const std::string& name) {
  return std::make_shared<const World>(readMap(UNDERWAY_SOURCE_DIR "/maps/" + name + ".yaml")->world);
}

/// Time enough on any machine, also under a sanitizer; what is found does not depend on it.
inline Planner::Clock::time_point soon() { return Planner::Clock::now() + std::chrono::seconds(120); }

inline Request requestFor(const Pose& start, const Pose& goal, Policy policy = Policy::kPriority) {
  Request request;
  request.start = start;
  request.goal = goal.position();
  request.goal_yaw = goal.yaw;
  request.policy = policy;
  return request;
}

/// A roadmap of so many batches.
inline Roadmap grown(const std::shared_ptr<const Checker>& checker, std::uint64_t seed, unsigned batches) {
  Growth growth(checker, {seed, 3.0});
  for (unsigned i = 0; i < batches; ++i) growth.addBatch();
  return growth.freeze();
}

/// Metres a plan moves in a mode.
inline double metresIn(const Plan& plan, ModeId mode) {
  double sum = 0.0;
  for (const Segment& segment : plan.segments)
    if (segment.motion.mode == mode) sum += length(segment.motion);
  return sum;
}

}  // namespace underway::test
