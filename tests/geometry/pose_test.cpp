#include "geometry/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Pose, NormalisedAnglesLieAboveMinusPiUpToPi) {
  EXPECT_EQ(normalizedAngle(-kPi), kPi);
  EXPECT_EQ(normalizedAngle(kPi), kPi);
  EXPECT_NEAR(normalizedAngle(7.0), 7.0 - 2.0 * kPi, 1e-15);
  test::RandomWorld random(1);
  for (int i = 0; i < 10000; ++i) {
    const double angle = random.between(-100.0, 100.0);
    const double dut = normalizedAngle(angle);
    ASSERT_GT(dut, -kPi);
    ASSERT_LE(dut, kPi);
    ASSERT_NEAR(std::remainder(dut - angle, 2.0 * kPi), 0.0, 1e-12);
  }
}

TEST(Pose, CounterClockwiseWaysLieBetweenZeroAndOneRevolution) {
  EXPECT_EQ(counterClockwise(1.0, 1.0), 0.0);
  EXPECT_NEAR(counterClockwise(0.0, -0.5), 2.0 * kPi - 0.5, 1e-15);
  EXPECT_NEAR(counterClockwise(3.0, -3.0), 2.0 * kPi - 6.0, 1e-15);
}

TEST(Pose, ComposingWithADisplacementWithoutTurnKeepsTheHeadingBitForBit) {
  const Pose base{1.0, 2.0, 7.123456789};
  EXPECT_EQ(compose(base, {0.3, 0.1, 0.0}).yaw, base.yaw);
}

TEST(Pose, BeforeUndoesCompose) {
  test::RandomWorld random(2);
  for (int i = 0; i < 1000; ++i) {
    const Pose to = random.pose();
    const Pose by{random.between(-1.0, 1.0), random.between(-1.0, 1.0), i % 2 == 0 ? 0.0 : random.angle()};
    const Pose dut = compose(before(to, by), by);
    ASSERT_NEAR(dut.x, to.x, 1e-14);
    ASSERT_NEAR(dut.y, to.y, 1e-14);
    ASSERT_NEAR(normalizedAngle(dut.yaw - to.yaw), 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace underway
