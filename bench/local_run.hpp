#pragma once

#include <functional>

#include "bench/local_rooms.hpp"
#include "local/godzila/godzila.hpp"
#include "sim/robot.hpp"

namespace underway::bench {

/// How one run ended.
struct PureRun {
  bool has_arrived = false;
  bool has_collided = false;  ///< by either judge
  bool is_disputed = false;   ///< the judges of the simulated robot disagree
  double time_s = 0.0;        ///< simulated
  unsigned traps = 0;
};

/// Called after each tick with the truth.
using Watch = std::function<void(const sim::SimulatedRobot&, Godzila::State)>;

/// GODZILA alone in a room: simulated robot, honest noise, judged by the truth. It knows where the goal is
/// relative to it, as by a camera, with the pose's noise.
[[nodiscard]] PureRun drivePurely(const PureRoom& room, const std::shared_ptr<const Robot>& robot,
                                  PureSettings settings, std::uint64_t seed, double limit_s,
                                  const Watch& watch = {});

}  // namespace underway::bench
