#include "sim/robot.hpp"

#include <algorithm>
#include <cmath>

#include "local/low.hpp"

namespace underway::sim {
namespace {

constexpr double kStroke_m = 0.0777;  // of a whole cycle without slip (Brooks 2017, chapter 4)

}  // namespace

SimulatedRobot::SimulatedRobot(std::shared_ptr<const World> truth, std::shared_ptr<const Robot> robot,
                               const Pose& start, ModeId mode, std::uint64_t seed, const Flaws& flaws)
    : world_(std::move(truth)),
      robot_(std::move(robot)),
      checker_(world_, robot_),
      second_judge_(world_, robot_),
      sensors_(*world_, robot_, flaws, start),
      limits_(standingLimits(*robot_)),
      flaws_(flaws),
      random_(seed) {
  truth_.pose = start;
  truth_.mode = mode;
  std::normal_distribution<double> unit;
  const double size = flaws.drift_rad_per_m + flaws.drift_sigma_rad_per_m * unit(random_);
  drift_rad_per_m_ = std::bernoulli_distribution()(random_) ? size : -size;
  check(stay(mode, start));
}

bool SimulatedRobot::isLying() const {
  return isLow(*robot_, truth_.mode) || switching_ != nullptr || has_fallen_;
}

const Senses& SimulatedRobot::sense() {
  senses_ = {};
  senses_.mode = truth_.mode;
  senses_.is_switching = switching_ != nullptr;
  senses_.cycles = cycles_;
  senses_.has_fallen = has_fallen_;
  sensors_.sense({.now_s = now_s(),
                  .pose = truth_.pose,
                  .is_upright = !isLying(),
                  .can_localise = !is_lost_ && switching_ == nullptr && !has_fallen_,
                  .heading_rad = truth_.pose.yaw},
                 senses_, random_);
  return senses_;
}

void SimulatedRobot::step(const Command& command) {
  const Mode& mode = robot_->modes[truth_.mode];
  sensors_.look(command.look_rad);
  if (has_fallen_) {
    // It lies where it fell.
  } else if (switching_ != nullptr) {
    goOnSwitching();
  } else if (command.change_to && *command.change_to != truth_.mode && cycle_left_s_ <= 0.0) {
    beginSwitch(*command.change_to);
  } else if (mode.canTurn()) {
    walk(command.velocity);
  } else {
    crawl(command.velocity.x_mps);
  }
  ++ticks_;
  sensors_.remember(truth_.pose);
}

void SimulatedRobot::walk(const Velocity& velocity) {
  const Velocity done = limited(velocity, limits_);
  const double way = std::hypot(done.x_mps, done.y_mps) * kTick_s;
  move(done.x_mps * kTick_s, done.y_mps * kTick_s, done.turn_radps * kTick_s + drift_rad_per_m_ * way);
}

void SimulatedRobot::crawl(double wanted_mps) {
  const double speed = robot_->modes[truth_.mode].speed(Sense::kForward);
  if (cycle_left_s_ <= 0.0) {
    if (wanted_mps <= 0.0 || speed <= 0.0) return;
    cycle_left_s_ = kStroke_m / speed;
    std::normal_distribution<double> lost(flaws_.stroke_lost, flaws_.stroke_sigma);
    // Slower is a shorter stroke in the same time.
    cycle_share_ = std::min(wanted_mps / speed, 1.0) * std::clamp(1.0 - lost(random_), 0.0, 1.2);
  }
  if (is_stalled_) return;  // the cycle does not end
  const double time = std::min(kTick_s, cycle_left_s_);
  const double way = speed * time * cycle_share_;
  move(way, 0.0, drift_rad_per_m_ * way);
  cycle_left_s_ -= time;
  if (cycle_left_s_ < 1e-9) cycle_left_s_ = 0.0, ++cycles_;
}

void SimulatedRobot::beginSwitch(ModeId to) {
  switching_ = robot_->findSwitch(truth_.mode, to);
  if (switching_ == nullptr) return;  // it cannot: nothing happens
  check(switchModes(*switching_, truth_.pose));
  switch_left_s_ = switching_->duration_s;
  if (switch_left_s_ <= 0.0) goOnSwitching();
}

void SimulatedRobot::goOnSwitching() {
  switch_left_s_ -= kTick_s;
  if (switch_left_s_ > 1e-9) return;
  truth_.pose = compose(truth_.pose, switching_->displacement);
  truth_.mode = switching_->to;
  switching_ = nullptr;
  check(stay(truth_.mode, truth_.pose));
}

/// A turn, then along x, then along y: each an exact motion.
void SimulatedRobot::move(double x_m, double y_m, double turn_rad) {
  const ModeId mode = truth_.mode;
  const auto go = [&](const Motion& motion) {
    check(motion);
    truth_.moved_m += length(motion);
    truth_.pose = motion.to;
  };
  if (turn_rad != 0.0) go(turn(mode, truth_.pose, turn_rad, normalizedAngle(truth_.pose.yaw + turn_rad)));
  if (x_m != 0.0)
    go(translate(mode, x_m > 0.0 ? Sense::kForward : Sense::kBackward, truth_.pose, std::abs(x_m)));
  if (y_m != 0.0) go(translate(mode, y_m > 0.0 ? Sense::kLeft : Sense::kRight, truth_.pose, std::abs(y_m)));
}

void SimulatedRobot::check(const Motion& motion) {
  if (truth_.has_collided) return;
  const bool is_free = checker_.isFree(motion, 0.0);
  const bool is_second_free = !second_judge_.touches(motion);
  if (is_free != is_second_free) truth_.is_disputed |= second_judge_.disputes(motion, is_free);
  if (is_free && is_second_free) return;
  truth_.has_collided = true;
  const auto touched = checker_.blockers(motion, 0.0, 1);
  truth_.with = !touched.empty() ? touched.front() : is_free ? "what one judge alone saw" : "the bounds";
}

}  // namespace underway::sim
