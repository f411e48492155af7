#include "sim/physics/physical_robot.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace underway::physics {
namespace {

std::vector<OrientedBox> boxesOf(const World& world) {
  std::vector<OrientedBox> boxes;
  for (const Obstacle& obstacle : world.obstacles()) {
    boxes.push_back(obstacle.box);
    boxes.back().center_m.z -= world.floorZ();
  }
  return boxes;
}

}  // namespace

Expected<PhysicalRobot> PhysicalRobot::make(const std::filesystem::path& model, const World& truth,
                                            std::shared_ptr<const Robot> robot, const Pose& start,
                                            const gait::CrawlGait& gait, const Conditions& conditions,
                                            const sim::Flaws& flaws) {
  auto simulation = Simulation::make(model, {.ground = {}, .obstacles = boxesOf(truth)}, conditions);
  if (!simulation) return tl::unexpected(simulation.error());
  auto player = gait::CrawlPlayer::make(gait::naoCrawler(), gait);
  if (!player) throw std::invalid_argument("NAO cannot crawl so: " + player.error().message);
  simulation->start(player->down(0.0), Posture::kStanding, start);
  GaitRunner runner(robot, std::move(*player), 0);
  return PhysicalRobot(std::move(*simulation), std::move(runner), truth, std::move(robot), start, conditions,
                       flaws);
}

PhysicalRobot::PhysicalRobot(Simulation simulation, GaitRunner runner, const World& truth,
                             std::shared_ptr<const Robot> robot, const Pose& start,
                             const Conditions& conditions, const sim::Flaws& flaws)
    : simulation_(std::move(simulation)),
      runner_(std::move(runner)),
      robot_(std::move(robot)),
      sensors_(truth, robot_, flaws, start),
      limits_(standingLimits(*robot_)),
      start_rad_(start.yaw),
      random_(conditions.seed + 2) {
  std::normal_distribution<double> size(flaws.drift_rad_per_m, flaws.drift_sigma_rad_per_m);
  drift_rad_per_m_ = size(random_) * (std::bernoulli_distribution()(random_) ? 1.0 : -1.0);
  observe();
}

double PhysicalRobot::heading() const { return normalizedAngle(start_rad_ + simulation_.imuHeading()); }

const Senses& PhysicalRobot::sense() {
  senses_ = {};
  senses_.mode = runner_.mode();
  senses_.is_switching = runner_.isSwitching();
  senses_.cycles = runner_.cycles();
  senses_.has_fallen = !truth_.is_upright;
  const bool is_lying = runner_.isSwitching() || isLow(*robot_, runner_.mode());
  sensors_.sense({.now_s = now_s(),
                  .pose = truth_.pose,
                  .is_upright = !is_lying,
                  .can_localise = !runner_.isSwitching(),
                  .heading_rad = heading()},
                 senses_, random_);
  return senses_;
}

void PhysicalRobot::step(const Command& command) {
  sensors_.look(command.look_rad);
  const auto joints = runner_.tick(command, heading(), sim::Sensors::kTick_s);
  if (!joints && runner_.isWalking()) walk(command.velocity);
  const Recording recording = joints ? simulation_.play(*joints, Posture::kLying)
                                     : simulation_.hold(sim::Sensors::kTick_s, Posture::kLying);
  truth_.touches.insert(recording.touches.begin(), recording.touches.end());
  ++ticks_;
  observe();
  sensors_.remember(truth_.pose);
}

void PhysicalRobot::walk(const Velocity& velocity) {
  constexpr double kTick_s = sim::Sensors::kTick_s;
  const Velocity done = limited(velocity, limits_);
  const double way = std::hypot(done.x_mps, done.y_mps) * kTick_s;
  simulation_.carry(
      {done.x_mps * kTick_s, done.y_mps * kTick_s, done.turn_radps * kTick_s + drift_rad_per_m_ * way});
}

void PhysicalRobot::observe() {
  const Sample now = simulation_.now();
  const bool is_low = isLow(*robot_, runner_.mode());
  truth_.pose = is_low ? now.lying : now.standing;
  truth_.mode = runner_.mode();
  const double pitch_rad = is_low ? 0.5 * std::numbers::pi : 0.0;
  const double most_rad = is_low ? 0.8 : 0.35;  // a push raises the shoulders
  if (!runner_.isSwitching())
    truth_.is_upright = std::abs(now.pitch_rad - pitch_rad) < most_rad && std::abs(now.roll_rad) < most_rad;
}

}  // namespace underway::physics
