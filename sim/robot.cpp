#include "sim/robot.hpp"

#include <algorithm>
#include <cmath>

namespace underway::sim {
namespace {

constexpr double kStroke_m = 0.0777;  // of a whole cycle without slip (Brooks 2017, chapter 4)
constexpr LidarSettings kWaist{};
constexpr double kMostLook_rad = 2.08;  // NAO's HeadYaw

/// A depth camera, as if its points were seen from above: nearest of all heights up to the standing body's.
LidarSettings depthFor(const DepthSense& sense, const Robot& robot) {
  LidarSettings settings;
  settings.beams = depthBeamsOf(sense.field_rad);
  settings.heights_m = {0.02, robot.modes.front().body_m.z.max};
  settings.nearest_m = 0.02;
  settings.farthest_m = sense.farthest_m;
  return settings;
}

LidarSettings lidarFor(const LidarSense& sense) {
  LidarSettings settings = kWaist;
  settings.heights_m = {sense.height_m, sense.height_m};
  return settings;
}

LidarSettings noisier(LidarSettings settings, double scale) {
  settings.sigma_m *= scale;
  settings.sigma_share *= scale;
  return settings;
}

}  // namespace

Flaws Flaws::times(double factor) const {
  Flaws more = *this;
  for (double* noise : {&more.pose_sigma_m, &more.pose_sigma_rad, &more.stroke_sigma, &more.drift_rad_per_m,
                        &more.drift_sigma_rad_per_m, &more.lidar_scale})
    *noise *= factor;
  return more;
}

SimulatedRobot::SimulatedRobot(std::shared_ptr<const World> truth, std::shared_ptr<const Robot> robot,
                               const Pose& start, ModeId mode, std::uint64_t seed, const Flaws& flaws)
    : world_(std::move(truth)),
      robot_(std::move(robot)),
      checker_(world_, robot_),
      second_judge_(world_, robot_),
      limits_(standingLimits(*robot_)),
      flaws_(flaws),
      random_(seed) {
  const SensesOfRobot& senses = robot_->senses;
  if (senses.waist) waist_.emplace(*world_, noisier(lidarFor(*senses.waist), flaws.lidar_scale));
  if (senses.head) head_.emplace(*world_, noisier(lidarFor(*senses.head), flaws.lidar_scale));
  if (senses.depth) depth_.emplace(*world_, noisier(depthFor(*senses.depth, *robot_), flaws.lidar_scale));
  truth_.pose = start;
  truth_.mode = mode;
  past_.assign(static_cast<std::size_t>(flaws.late_ticks) + 1, start);
  std::normal_distribution<double> unit;
  const double size = flaws.drift_rad_per_m + flaws.drift_sigma_rad_per_m * unit(random_);
  drift_rad_per_m_ = std::bernoulli_distribution()(random_) ? size : -size;
  check(stay(mode, start));
}

bool SimulatedRobot::isLying() const {
  return robot_->modes[truth_.mode].body_m.z.max < robot_->modes.front().body_m.z.max ||
         switching_ != nullptr || has_fallen_;
}

const Senses& SimulatedRobot::sense() {
  std::normal_distribution<double> unit;
  senses_ = {};
  senses_.now_s = now_s();
  senses_.mode = truth_.mode;
  senses_.is_switching = switching_ != nullptr;
  senses_.cycles = cycles_;
  senses_.has_fallen = has_fallen_;
  const bool is_lying = isLying();
  const auto& lidar = is_lying ? head_ : waist_;
  if (lidar) {
    lidar->look(truth_.pose, scan_, random_);
    scan_.stamp_s = now_s();
    senses_.scan = &scan_;
  }
  if (depth_ && !is_lying) {
    const Pose& at = truth_.pose;
    depth_->look({at.x, at.y, at.yaw + look_rad_}, depth_scan_, random_);
    depth_scan_.beams.first_rad += look_rad_;
    depth_scan_.stamp_s = now_s();
    senses_.depth = &depth_scan_;
  }
  const double heading_noise = flaws_.pose_sigma_rad * unit(random_);
  const Pose& then = past_.front();
  senses_.heading_rad = normalizedAngle(truth_.pose.yaw + heading_noise);
  // Localisation needs a lidar that sees.
  if (lidar && !is_lost_ && switching_ == nullptr && !has_fallen_)
    senses_.pose = {
        now_s() - kTick_s * flaws_.late_ticks,
        {then.x + flaws_.pose_sigma_m * unit(random_), then.y + flaws_.pose_sigma_m * unit(random_),
         normalizedAngle(then.yaw + flaws_.pose_sigma_rad * unit(random_))}};
  return senses_;
}

void SimulatedRobot::step(const Command& command) {
  const Mode& mode = robot_->modes[truth_.mode];
  look_rad_ = std::clamp(command.look_rad, -kMostLook_rad, kMostLook_rad);
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
  std::rotate(past_.begin(), past_.begin() + 1, past_.end());
  past_.back() = truth_.pose;
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
