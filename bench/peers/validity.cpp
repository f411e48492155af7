#include "bench/peers/validity.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>

namespace underway::bench {
namespace {

constexpr double kLeastStepOver_m = 0.005;

fcl::Transform3d transformOf(const OrientedBox& box) {
  const Rotation rows = rotation(box);
  fcl::Transform3d placed = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const Vec3& row = rows.at(static_cast<std::size_t>(i));
    placed.linear().row(i) << row.x, row.y, row.z;
  }
  placed.translation() << box.center_m.x, box.center_m.y, box.center_m.z;
  return placed;
}

double middle(Range range) { return 0.5 * (range.min + range.max); }

Range slabOf(const Mode& mode) { return {std::max(mode.step_over_m, kLeastStepOver_m), mode.body_m.z.max}; }

bool collideOnce(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  static const fcl::CollisionRequestd kBoolean(1, false);
  fcl::CollisionResultd result;
  auto& touches = *static_cast<bool*>(data);
  touches = fcl::collide(a, b, kBoolean, result) > 0;
  return touches;  // the first is enough
}

}  // namespace

FclValidity::FclValidity(const ob::SpaceInformationPtr& space, const World& world, const Robot& robot)
    : ob::StateValidityChecker(space), world_(world), robot_(robot) {
  std::vector<fcl::CollisionObjectd*> all;
  for (const Obstacle& obstacle : world.obstacles()) {
    const Vec3& size = obstacle.box.size_m;
    obstacles_.push_back(std::make_unique<fcl::CollisionObjectd>(
        std::make_shared<fcl::Boxd>(size.x, size.y, size.z), transformOf(obstacle.box)));
    all.push_back(obstacles_.back().get());
  }
  tree_.registerObjects(all);
  tree_.setup();
  for (const Mode& mode : robot.modes)
    bodies_.push_back(std::make_shared<fcl::Boxd>(mode.body_m.x.length() + 2.0 * robot.margin_m,
                                                  mode.body_m.y.length() + 2.0 * robot.margin_m,
                                                  slabOf(mode).length()));
}

bool FclValidity::isValid(const ob::State* state) const { return isValid(poseOf(*state), modeOf(*state)); }

bool FclValidity::isValid(const Pose& pose, ModeId mode) const {
  const BodyBox& body = robot_.modes[mode].body_m;
  for (const double x : {body.x.min, body.x.max})
    for (const double y : {body.y.min, body.y.max})
      if (!world_.bounds().contains(transform(pose, {x, y}))) return false;
  const Point at = transform(pose, {middle(body.x), middle(body.y)});
  const double z = world_.floorZ() + middle(slabOf(robot_.modes[mode]));
  const OrientedBox placed{{at.x, at.y, z}, {1.0, 1.0, 1.0}, {0.0, 0.0, pose.yaw}};
  fcl::CollisionObjectd moving(bodies_[mode], transformOf(placed));
  bool touches = false;
  tree_.collide(&moving, &touches, collideOnce);
  return !touches;
}

ModeMotionValidator::ModeMotionValidator(const ob::SpaceInformationPtr& space, const FclValidity& validity,
                                         const Robot& robot)
    : ob::DiscreteMotionValidator(space), validity_(validity), robot_(robot) {}

bool ModeMotionValidator::checkMotion(const ob::State* from, const ob::State* to) const {
  const ModeId mode = modeOf(*from);
  const ModeId other = modeOf(*to);
  if (mode == other) return ob::DiscreteMotionValidator::checkMotion(from, to);
  if (robot_.findSwitch(mode, other) == nullptr) return false;
  const unsigned steps = std::max(1U, si_->getStateSpace()->validSegmentCount(from, to));
  ob::State* between = si_->allocState();
  bool is_valid = true;
  for (unsigned i = 0; i <= steps && is_valid; ++i) {
    si_->getStateSpace()->interpolate(from, to, static_cast<double>(i) / steps, between);
    const Pose pose = poseOf(*between);
    is_valid = validity_.isValid(pose, mode) && validity_.isValid(pose, other);
  }
  si_->freeState(between);
  return is_valid;
}

bool ModeMotionValidator::checkMotion(const ob::State* from, const ob::State* to,
                                      std::pair<ob::State*, double>& last_valid) const {
  if (modeOf(*from) == modeOf(*to)) return ob::DiscreteMotionValidator::checkMotion(from, to, last_valid);
  if (checkMotion(from, to)) return true;
  if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
  last_valid.second = 0.0;
  return false;
}

}  // namespace underway::bench
