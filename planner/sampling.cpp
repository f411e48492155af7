#include "planner/sampling.hpp"

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/samplers/BridgeTestValidStateSampler.h>
#include <ompl/base/samplers/GaussianValidStateSampler.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway {
namespace {

namespace ob = ompl::base;
using PoseState = ob::SE2StateSpace::StateType;
using ModeState = ob::DiscreteStateSpace::StateType;

constexpr unsigned kAttempts = 20;
constexpr double kNear_m = 0.3;        // spread of the Gaussian and bridge-test samplers: about one body
constexpr double kAlignedShare = 0.5;  // of the headings that go along or across an obstacle

PoseState& poseIn(ob::State* state) { return *state->as<ob::CompoundState>()->as<PoseState>(0); }
const PoseState& poseIn(const ob::State* state) { return *state->as<ob::CompoundState>()->as<PoseState>(0); }
Pose poseOf(const ob::State* state) {
  const PoseState& pose = poseIn(state);
  return {pose.getX(), pose.getY(), pose.getYaw()};
}

void set(ob::State* state, const Pose& pose, ModeId mode) {
  poseIn(state).setXY(pose.x, pose.y);
  poseIn(state).setYaw(normalizedAngle(pose.yaw));
  state->as<ob::CompoundState>()->as<ModeState>(1)->value = mode;
}

/// States of one mode over the bounds. Half the headings are aligned with an obstacle: narrow places are
/// rarely passable at any other. Its random numbers depend on its seed alone.
class AlignedSampler : public ob::StateSampler {
 public:
  AlignedSampler(const ob::StateSpace* space, const World& world, ModeId mode, std::uint64_t seed)
      : ob::StateSampler(space), world_(world), mode_(mode) {
    rng_.setLocalSeed(static_cast<std::uint_fast32_t>(seed));
  }

  void sampleUniform(ob::State* state) override {
    const Bounds& bounds = world_.bounds();
    const Point at = transform(
        bounds.corner, {rng_.uniformReal(0.0, bounds.width_m), rng_.uniformReal(0.0, bounds.height_m)});
    set(state, {at.x, at.y, heading()}, mode_);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double away) override {
    const Pose pose = poseOf(near);
    set(state, {pose.x + rng_.uniformReal(-away, away), pose.y + rng_.uniformReal(-away, away), pose.yaw},
        mode_);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    const Pose pose = poseOf(mean);
    set(state, {rng_.gaussian(pose.x, deviation), rng_.gaussian(pose.y, deviation), pose.yaw}, mode_);
  }

  /// A pose below an obstacle, mostly along or across it.
  void sampleBelow(ob::State* state, const OrientedBox& box) {
    const Point at =
        transform({box.center_m.x, box.center_m.y, box.rpy_rad.z},
                  {rng_.uniformReal(-0.5, 0.5) * box.size_m.x, rng_.uniformReal(-0.5, 0.5) * box.size_m.y});
    const double yaw = rng_.uniform01() < 0.75 ? alongOrAcross(box) : anyHeading();
    set(state, {at.x, at.y, yaw}, mode_);
  }
  std::size_t indexBelow(std::size_t count) {
    return static_cast<std::size_t>(rng_.uniformInt(0, static_cast<int>(count) - 1));
  }

 private:
  double anyHeading() { return rng_.uniformReal(-std::numbers::pi, std::numbers::pi); }
  double alongOrAcross(const OrientedBox& box) {
    return box.rpy_rad.z + 0.5 * std::numbers::pi * rng_.uniformInt(0, 3);
  }
  double heading() {
    if (world_.obstacles().empty() || rng_.uniform01() >= kAlignedShare) return anyHeading();
    return alongOrAcross(world_.obstacles()[indexBelow(world_.obstacles().size())].box);
  }

  const World& world_;
  ModeId mode_;
};

}  // namespace

struct PoseSampler::Space {
  Space(const Checker& c, ModeId m, std::vector<std::size_t> hanging, std::uint64_t s)
      : checker(c), mode(m), overhangs(std::move(hanging)), seed(s) {
    ompl::msg::noOutputHandler();
    auto poses = std::make_shared<ob::SE2StateSpace>();
    poses->setBounds(boundsOf(checker.world()));
    auto modes = std::make_shared<ob::DiscreteStateSpace>(  // of two at least: OMPL refuses a space of one
        0, std::max(1, static_cast<int>(checker.robot().modes.size()) - 1));
    auto space = std::make_shared<ob::CompoundStateSpace>();
    space->addSubspace(poses, 1.0);
    space->addSubspace(modes, 1.0);
    space->setStateSamplerAllocator([this](const ob::StateSpace* over) {
      return std::make_shared<AlignedSampler>(over, checker.world(), mode, seed + samplers++);
    });
    info = std::make_shared<ob::SpaceInformation>(space);
    info->setStateValidityChecker(
        [this](const ob::State* state) { return checker.isFree(stay(mode, poseOf(state))); });
    info->setup();
    uniform = std::make_unique<ob::UniformValidStateSampler>(info.get());
    gaussian = std::make_unique<ob::GaussianValidStateSampler>(info.get());
    bridge = std::make_unique<ob::BridgeTestValidStateSampler>(info.get());
    gaussian->setStdDev(kNear_m);
    bridge->setStdDev(kNear_m);
    for (ob::ValidStateSampler* sampler : {static_cast<ob::ValidStateSampler*>(uniform.get()),
                                           static_cast<ob::ValidStateSampler*>(gaussian.get()),
                                           static_cast<ob::ValidStateSampler*>(bridge.get())})
      sampler->setNrAttempts(kAttempts);
    low_places = std::make_unique<AlignedSampler>(space.get(), checker.world(), mode, seed ^ 0x5bd1e995U);
  }

  static ob::RealVectorBounds boundsOf(const World& world) {
    ob::RealVectorBounds bounds(2);
    const auto corners = world.bounds().corners();
    for (unsigned axis = 0; axis < 2; ++axis) {
      Range range{INFINITY, -INFINITY};
      for (const Point corner : corners) {
        const double value = axis == 0 ? corner.x : corner.y;
        range = {std::min(range.min, value), std::max(range.max, value)};
      }
      bounds.setLow(axis, range.min);
      bounds.setHigh(axis, range.max);
    }
    return bounds;
  }

  bool sampleLowPlace(ob::State* state) {
    if (overhangs.empty()) return false;
    for (unsigned attempt = 0; attempt < kAttempts; ++attempt) {
      const std::size_t below = overhangs[low_places->indexBelow(overhangs.size())];
      low_places->sampleBelow(state, checker.world().obstacles()[below].box);
      if (info->isValid(state) && !checker.isFree(stay(0, poseOf(state)))) return true;
    }
    return false;
  }

  const Checker& checker;
  ModeId mode;
  std::vector<std::size_t> overhangs;
  std::uint64_t seed;
  std::uint64_t samplers = 0;  // made so far: each gets a seed of its own
  ob::SpaceInformationPtr info;
  std::unique_ptr<ob::UniformValidStateSampler> uniform;
  std::unique_ptr<ob::GaussianValidStateSampler> gaussian;
  std::unique_ptr<ob::BridgeTestValidStateSampler> bridge;
  std::unique_ptr<AlignedSampler> low_places;
};

PoseSampler::PoseSampler(const Checker& checker, ModeId mode, std::vector<std::size_t> overhangs,
                         std::uint64_t seed)
    : space_(std::make_unique<Space>(checker, mode, std::move(overhangs), seed)) {}
PoseSampler::~PoseSampler() = default;

std::optional<Pose> PoseSampler::sample(Kind kind) {
  ob::ScopedState<> state(space_->info);
  bool found = false;
  switch (kind) {
    case Kind::kUniform:
      found = space_->uniform->sample(state.get());
      break;
    case Kind::kGaussian:
      found = space_->gaussian->sample(state.get());
      break;
    case Kind::kBridge:
      found = space_->bridge->sample(state.get());
      break;
    case Kind::kLowPlace:
      found = space_->sampleLowPlace(state.get());
      break;
  }
  return found ? std::optional(poseOf(state.get())) : std::nullopt;
}

double PoseSampler::freeShare(unsigned draws) {
  ob::ScopedState<> state(space_->info);
  const auto sampler = space_->info->allocStateSampler();
  std::vector<Motion> poses;
  for (unsigned i = 0; i < draws; ++i) {
    sampler->sampleUniform(state.get());
    poses.push_back(stay(space_->mode, poseOf(state.get())));
  }
  const std::vector<char> free = space_->checker.areFree(poses, space_->checker.robot().margin_m);
  return static_cast<double>(std::count(free.begin(), free.end(), 1)) / draws;
}

}  // namespace underway
