#pragma once

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "bench/peers/peer.hpp"

namespace underway::bench {

namespace ob = ompl::base;

/// A state of SE(2) times the modes.
[[nodiscard]] Pose poseOf(const ob::State& state);
[[nodiscard]] ModeId modeOf(const ob::State& state);
void setState(ob::State& state, const Pose& pose, ModeId mode);

/// The space, with the resolution at which motions are sampled: 1 cm, 2 degrees.
[[nodiscard]] ob::StateSpacePtr makeSpace(const World& world, const Robot& robot);

/// Time that motions take, as peer.hpp says.
class TimeObjective : public ob::OptimizationObjective {
 public:
  TimeObjective(const ob::SpaceInformationPtr& space, const Robot& robot);
  [[nodiscard]] ob::Cost stateCost(const ob::State* state) const override;
  [[nodiscard]] ob::Cost motionCost(const ob::State* from, const ob::State* to) const override;
  [[nodiscard]] ob::Cost motionCostHeuristic(const ob::State* from, const ob::State* to) const override;

 private:
  const Robot& robot_;
  std::vector<double> speed_mps_;   // by mode: its best
  std::vector<double> turn_radps_;  // by mode
  double fastest_mps_ = 0.0;
};

}  // namespace underway::bench
