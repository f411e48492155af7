#pragma once

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/StateValidityChecker.h>

#include <memory>
#include <vector>

#include "bench/peers/space.hpp"

namespace underway::bench {

/// Whether a mode's box, grown by the margin, touches none of the obstacles in its slab and is in bounds.
class FclValidity : public ob::StateValidityChecker {
 public:
  FclValidity(const ob::SpaceInformationPtr& space, const World& world, const Robot& robot);
  [[nodiscard]] bool isValid(const ob::State* state) const override;
  [[nodiscard]] bool isValid(const Pose& pose, ModeId mode) const;

 private:
  const World& world_;
  const Robot& robot_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> obstacles_;
  fcl::DynamicAABBTreeCollisionManagerd tree_;
  std::vector<std::shared_ptr<fcl::CollisionGeometryd>> bodies_;  // by mode
};

/// As OMPL's own; a motion between modes is valid if there is such a switch and each of its states is valid
/// in both modes.
class ModeMotionValidator : public ob::DiscreteMotionValidator {
 public:
  ModeMotionValidator(const ob::SpaceInformationPtr& space, const FclValidity& validity, const Robot& robot);
  bool checkMotion(const ob::State* from, const ob::State* to) const override;
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override;

 private:
  const FclValidity& validity_;
  const Robot& robot_;
};

}  // namespace underway::bench
