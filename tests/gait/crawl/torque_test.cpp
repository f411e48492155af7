#include "gait/crawl/torque.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/crawl/evaluate.hpp"
#include "gait/nao.hpp"
#include "tests/gait/random_numbers.hpp"

namespace underway::gait {
namespace {

constexpr double kGravity_mps2 = 9.81;

PlanePoint centerOf(const LinkMass& mass, PlanePoint from, PlanePoint to) {
  const double angle = std::atan2(to.z - from.z, to.x - from.x);
  return from + along(mass.along * length(to - from), angle) + along(mass.across_m, angle + 0.5 * M_PI);
}

double potential(const ChainMasses& masses, const ChainPoints& points) {
  double energy = 0.0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    energy += kGravity_mps2 * masses[i].kg * centerOf(masses[i], points[i], points[i + 1]).z;
  return energy;
}

/// Virtual work, which knows nothing of levers: moving along the closed chain, the torques of both sides do
/// the work that gravity takes, whatever the internal force (the pins do none).
TEST(Torque, DoesTheWorkThatGravityTakes) {
  test::RandomNumbers random(1);
  const ChainMasses masses = chainMassesOf(nao());
  const LinkLengths lengths = naoCrawler().lengths(0.0565);
  const PlanePoint elbow{0.43, 0.0};
  for (int i = 0; i < 2000; ++i) {
    const Triplet at{random.between(-0.05, 0.7), random.between(-0.5, 0.4), random.between(-1.5, -0.6)};
    const Triplet way{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const auto pose = [&](double step) {
      return *pushPose(
          lengths, {at.knee + step * way.knee, at.hip + step * way.hip, at.alpha + step * way.alpha}, elbow);
    };
    constexpr double kStep = 1e-5;
    const ChainAngles before = pose(-kStep);
    const ChainAngles after = pose(kStep);
    const double lifted_j =
        potential(masses, pointsOf(lengths, after)) - potential(masses, pointsOf(lengths, before));
    for (const double internal_n : {0.0, 3.8, -20.0}) {
      const ChainLoad load =
          loadOf(masses, pointsOf(lengths, pose(0.0)), {InternalForce::Kind::kConstant, internal_n});
      double work_j = 0.0;
      for (std::size_t j = 0; j < 4; ++j)
        work_j += 2.0 * load.torques_nm[j] * (after.theta[j + 1] - before.theta[j + 1]);
      ASSERT_NEAR(work_j, lifted_j, 2e-7) << "case " << i << ", h " << internal_n;
    }
  }
}

TEST(Torque, SharesTheWeightBetweenToesAndElbows) {
  const ChainMasses masses = chainMassesOf(naoV40());
  const LinkLengths lengths = naoCrawler().lengths(0.0565);
  const auto chain = pushPose(lengths, nominalPush().at(0.5), {0.43, 0.0});
  ASSERT_TRUE(chain);
  const ChainLoad load = loadOf(masses, pointsOf(lengths, *chain), {});
  EXPECT_NEAR(load.toe_n + load.elbow_n, 45.8, 0.05) << "without forearms, of a robot of V4.0";
  EXPECT_GT(load.toe_n, 0.0);
  EXPECT_GT(load.elbow_n, load.toe_n) << "the trunk is nearer to the elbows";
}

TEST(Torque, ServosSettleWhereTheSumOfSquaresIsLeast) {
  const ChainMasses masses = chainMassesOf(nao());
  const LinkLengths lengths = naoCrawler().lengths(0.0565);
  const ChainPoints points = pointsOf(lengths, *pushPose(lengths, nominalPush().at(0.3), {0.43, 0.0}));
  const auto squares = [&](const ChainLoad& load) {
    double sum = 0.0;
    for (const double torque : load.torques_nm) sum += torque * torque;
    return sum;
  };
  const ChainLoad servo = loadOf(masses, points, {InternalForce::Kind::kServo, 0.0});
  for (const double off_n : {-5.0, -0.1, 0.1, 5.0}) {
    const ChainLoad other =
        loadOf(masses, points, {InternalForce::Kind::kConstant, servo.internal_n + off_n});
    EXPECT_LT(squares(servo), squares(other));
  }
}

/// Known for this model and the author's robot: nominal 2.67 and 1.44, Table 9 at .76 and .68 of it.
TEST(Torque, CostsWhatTheModelIsKnownToCost) {
  const ChainMasses masses = chainMassesOf(naoV40());
  PushSetting setting;
  setting.spread_m = naoCrawler().arm.spreadFor(0.08975);
  const auto cost = [&](const PushShape& push) {
    return torqueCost(evaluate(naoCrawler(), masses, push, setting), kPaperWeights);
  };
  setting.force.kind = InternalForce::Kind::kNone;
  EXPECT_NEAR(cost(nominalPush()), 2.674, 0.06);
  EXPECT_NEAR(cost(thesisOptimum()) / cost(nominalPush()), 0.758, 0.005);
  setting.force.kind = InternalForce::Kind::kServo;
  EXPECT_NEAR(cost(nominalPush()), 1.438, 0.06);
  EXPECT_NEAR(cost(thesisOptimum()) / cost(nominalPush()), 0.675, 0.005);
}

}  // namespace
}  // namespace underway::gait
