#pragma once

#include <cstdint>

#include "local/command.hpp"
#include "local/godzila/drive.hpp"
#include "local/godzila/escape.hpp"
#include "local/godzila/heading.hpp"
#include "local/godzila/settings.hpp"
#include "local/godzila/straight_line.hpp"
#include "local/godzila/trap.hpp"
#include "local/guard.hpp"
#include "local/window.hpp"

namespace underway {

struct PureSettings {
  GodzilaSettings godzila;
  StraightLineSettings straight_line;
  TrapSettings trap;
  EscapeSettings escape;
  GuardSettings guard;
  std::uint64_t seed = 1;      ///< of the escape's random goals
  bool keeps_traps = false;    ///< traps become virtual obstacles (window.hpp)
  double trap_radius_m = 0.3;  ///< of these [m]
};

/// GODZILA by itself (Brooks 2017, 3.3): from a scan and where the goal is to a velocity, without map or
/// plan. The optimisation finds the heading, the straight-line planner takes over where the way is free, the
/// escape where it is trapped; the guard has the last word.
///
/// Each tick takes bounded time, no locks and no memory. One object for one robot and one thread.
class Godzila {
 public:
  Godzila(const PureSettings& settings, const BodyBox& body, const SpeedLimits& limits, const Beams& beams);

  enum class State : std::uint8_t { kSeeking, kOnStraightLine, kEscaping, kArrived };
  struct Drive {
    Velocity velocity;
    State state = State::kSeeking;
  };
  /// One tick. `goal` is relative to the body frame now.
  [[nodiscard]] Drive tick(const Scan& scan, const Bearing& goal);

  [[nodiscard]] unsigned traps() const { return escape_.traps(); }

 private:
  [[nodiscard]] Bearing chooseGoal(const Scan& scan, const Bearing& goal, State& state);
  [[nodiscard]] Velocity guarded(const Scan& scan, const Velocity& wanted);
  [[nodiscard]] const Scan& withTraps(const Scan& scan);
  void reckon(const Velocity& velocity);

  PureSettings settings_;
  SpeedLimits limits_;
  HeadingOptimum optimum_;
  StraightLine straight_line_;
  TrapDetector trap_;
  Escape escape_;
  Guard guard_;
  VirtualObstacles virtual_;
  Scan seen_;      // the scan with virtual obstacles
  Pose reckoned_;  // by its own velocities, from where it began
  double now_s_ = 0.0;
};

}  // namespace underway
