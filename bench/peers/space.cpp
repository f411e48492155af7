#include "bench/peers/space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway::bench {
namespace {

constexpr double kStep_m = 0.01;
constexpr double kStep_rad = 2.0 * std::numbers::pi / 180.0;
constexpr double kModeWeight =
    0.05;  // [m] a mode away; more, and dense roadmaps have no neighbours in other modes

/// OMPL refuses a space without extent, which a robot of one mode has.
class ModeSpace : public ob::DiscreteStateSpace {
 public:
  explicit ModeSpace(const Robot& robot)
      : ob::DiscreteStateSpace(0, static_cast<int>(robot.modes.size()) - 1) {}
  [[nodiscard]] double getMaximumExtent() const override {
    return std::max(1.0, ob::DiscreteStateSpace::getMaximumExtent());
  }
};

}  // namespace

Pose poseOf(const ob::State& state) {
  const auto& se2 = *state.as<ob::CompoundState>()->as<ob::SE2StateSpace::StateType>(0);
  return {se2.getX(), se2.getY(), se2.getYaw()};
}

ModeId modeOf(const ob::State& state) {
  return static_cast<ModeId>(state.as<ob::CompoundState>()->as<ob::DiscreteStateSpace::StateType>(1)->value);
}

void setState(ob::State& state, const Pose& pose, ModeId mode) {
  auto& se2 = *state.as<ob::CompoundState>()->as<ob::SE2StateSpace::StateType>(0);
  se2.setXY(pose.x, pose.y);
  se2.setYaw(normalizedAngle(pose.yaw));
  state.as<ob::CompoundState>()->as<ob::DiscreteStateSpace::StateType>(1)->value = mode;
}

ob::StateSpacePtr makeSpace(const World& world, const Robot& robot) {
  const auto corners = world.bounds().corners();
  ob::RealVectorBounds bounds(2);
  bounds.low = {corners[0].x, corners[0].y};
  bounds.high = bounds.low;
  for (const Point corner : corners) {
    bounds.low = {std::min(bounds.low[0], corner.x), std::min(bounds.low[1], corner.y)};
    bounds.high = {std::max(bounds.high[0], corner.x), std::max(bounds.high[1], corner.y)};
  }
  const auto se2 = std::make_shared<ob::SE2StateSpace>();
  se2->setBounds(bounds);
  const auto& plane = se2->getSubspace(0);
  plane->setLongestValidSegmentFraction(kStep_m / plane->getMaximumExtent());
  se2->getSubspace(1)->setLongestValidSegmentFraction(kStep_rad / se2->getSubspace(1)->getMaximumExtent());
  const auto modes = std::make_shared<ModeSpace>(robot);
  const auto both = std::make_shared<ob::CompoundStateSpace>();
  both->addSubspace(se2, 1.0);
  both->addSubspace(modes, kModeWeight);
  both->lock();
  return both;
}

TimeObjective::TimeObjective(const ob::SpaceInformationPtr& space, const Robot& robot)
    : ob::OptimizationObjective(space), robot_(robot) {
  description_ = "time";
  double slowest_turn = 1e9;
  for (const Mode& mode : robot.modes)
    if (mode.canTurn()) slowest_turn = std::min(slowest_turn, mode.turn_speed_radps);
  for (const Mode& mode : robot.modes) {
    speed_mps_.push_back(*std::max_element(mode.speed_mps.begin(), mode.speed_mps.end()));
    turn_radps_.push_back(mode.canTurn() ? mode.turn_speed_radps : slowest_turn);
    fastest_mps_ = std::max(fastest_mps_, speed_mps_.back());
  }
}

ob::Cost TimeObjective::stateCost(const ob::State* /*state*/) const { return ob::Cost(0.0); }

ob::Cost TimeObjective::motionCost(const ob::State* from, const ob::State* to) const {
  const ModeId mode = modeOf(*from);
  const ModeId other = modeOf(*to);
  const Pose a = poseOf(*from);
  const Pose b = poseOf(*to);
  const double way_s = distance(a.position(), b.position()) / std::min(speed_mps_[mode], speed_mps_[other]);
  const double turn_s =
      std::abs(normalizedAngle(b.yaw - a.yaw)) / std::min(turn_radps_[mode], turn_radps_[other]);
  const Switch* change = mode == other ? nullptr : robot_.findSwitch(mode, other);
  return ob::Cost(way_s + turn_s + (change != nullptr ? change->duration_s : 0.0));
}

ob::Cost TimeObjective::motionCostHeuristic(const ob::State* from, const ob::State* to) const {
  return ob::Cost(distance(poseOf(*from).position(), poseOf(*to).position()) / fastest_mps_);
}

}  // namespace underway::bench
