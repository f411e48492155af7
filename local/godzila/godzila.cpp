#include "local/godzila/godzila.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

Godzila::Godzila(const PureSettings& settings, const BodyBox& body, const SpeedLimits& limits,
                 const Beams& beams)
    : settings_(settings),
      limits_(limits),
      optimum_(settings.godzila, beams),
      straight_line_(settings.straight_line),
      trap_(settings.trap),
      escape_(settings.escape, settings.seed),
      guard_(settings.guard, body, beams.count) {
  seen_.beams = beams;
  seen_.ranges_m.assign(beams.count, Scan::kNothing);
}

Godzila::Drive Godzila::tick(const Scan& scan, const Bearing& goal) {
  now_s_ += settings_.trap.tick_s;
  if (goal.range_m < settings_.godzila.goal_stopping_radius_m) return {{}, State::kArrived};
  Drive drive;
  const Bearing towards = chooseGoal(scan, goal, drive.state);
  const Scan& seen = settings_.keeps_traps ? withTraps(scan) : scan;
  const auto optimum = optimum_.of(seen, towards);
  drive.velocity = guarded(scan, velocityTowards(optimum, settings_.godzila, limits_));
  reckon(drive.velocity);
  return drive;
}

/// The goal itself, one on the straight line to it, or a random one.
Bearing Godzila::chooseGoal(const Scan& scan, const Bearing& goal, State& state) {
  const auto straight = straight_line_.intermediate(scan, goal, now_s_);
  if (straight) escape_.end();
  if (trap_.watch(reckoned_.position())) {
    trap_.reset();
    escape_.begin(scan, reckoned_, now_s_);
    if (settings_.keeps_traps) virtual_.add(reckoned_.position(), settings_.trap_radius_m);
  }
  if (const auto random = escape_.goal(scan, reckoned_, now_s_)) {
    state = State::kEscaping;
    return bearingOf(*random, reckoned_);
  }
  state = straight ? State::kOnStraightLine : State::kSeeking;
  return straight.value_or(goal);
}

const Scan& Godzila::withTraps(const Scan& scan) {
  std::copy(scan.ranges_m.begin(), scan.ranges_m.end(), seen_.ranges_m.begin());
  virtual_.shorten(seen_, reckoned_);
  return seen_;
}

Velocity Godzila::guarded(const Scan& scan, const Velocity& wanted) {
  guard_.clear();
  guard_.look(scan);
  const Velocity allowed = guard_.allowed(wanted);
  if (allowed != Velocity{}) return allowed;
  constexpr double kCareful = 0.3;  // share of the speed
  return guard_.allowed(limited(guard_.retreat(kCareful * limits_.backward_mps), limits_));
}

void Godzila::reckon(const Velocity& velocity) {
  const double tick = settings_.trap.tick_s;
  reckoned_ = compose(reckoned_, {velocity.x_mps * tick, velocity.y_mps * tick, velocity.turn_radps * tick});
}

}  // namespace underway
