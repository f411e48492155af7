#include "local/guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace underway {
namespace {

const BodyBox kBody{{-0.13, 0.13}, {-0.195, 0.195}, {0.0, 0.585}};
const GuardSettings kSettings{0.04, 1.0};

Guard guardWith(std::initializer_list<Point> points, GuardSettings settings = kSettings) {
  Guard guard(settings, kBody, 700);
  for (const Point p : points) guard.add(p);
  return guard;
}

TEST(Guard, AllowsAllWhereNothingIsNear) {
  const Velocity wanted{0.068, 0.0, 0.17};
  EXPECT_EQ(guardWith({}).allowed(wanted), wanted);
  EXPECT_EQ(guardWith({{0.6, 0.0}}).allowed(wanted), wanted);
}

TEST(Guard, StopsBeforeWhatIsAhead) {
  const Velocity allowed = guardWith({{0.175, 0.0}}).allowed({0.068, 0.0, 0.0});
  EXPECT_LT(allowed.x_mps, 0.01);
}

TEST(Guard, LetsTheRobotGoAwayFromWhatIsTooNear) {
  const Velocity back{-0.04, 0.0, 0.0};
  EXPECT_EQ(guardWith({{0.14, 0.0}}).allowed(back), back);
  EXPECT_EQ(guardWith({{0.14, 0.0}}).allowed({0.04, 0.0, 0.0}), Velocity{});
}

TEST(Guard, LetsItGoOnAlongAWallThatIsTooNear) {
  const Velocity on{0.04, 0.0, 0.0};
  EXPECT_EQ(guardWith({{-0.1, 0.21}, {0.0, 0.21}, {0.1, 0.21}, {0.15, 0.21}}).allowed(on), on);
}

TEST(Guard, KeepsOffOtherThingsWhereOnePointSeemsToLieInsideTheBody) {
  const Point inside{-0.1, 0.17};
  const Guard dut = guardWith({inside, {0.131, 0.0}});
  EXPECT_EQ(dut.allowed({0.02, 0.0, 0.0}), Velocity{});
  const Velocity away{0.0, -0.02, 0.0};
  EXPECT_EQ(dut.allowed(away), away);
}

TEST(Guard, DoesNotTurnACornerIntoAWall) {
  // A post beside the body, at a corner's radius.
  const Guard dut = guardWith({{0.0, 0.236}});
  EXPECT_LT(std::abs(dut.allowed({0.0, 0.0, 0.5}).turn_radps), 0.5);
}

TEST(Guard, NeverAllowsWhatComesNearerThanItsMargin) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-0.5, 0.5);
  for (int k = 0; k < 5000; ++k) {
    const Guard dut = guardWith({{at(random), at(random)}, {at(random), at(random)}});
    const Velocity allowed = dut.allowed({0.1 * at(random), 0.1 * at(random), 0.3 * at(random)});
    const double now = dut.distanceAfter({}, 0.0);
    ASSERT_GE(dut.distanceAfter(allowed, 1.0), std::min(0.04, now) - 1e-3) << "case " << k;
  }
}

TEST(Guard, KeepsASmallerMarginWhereItIsToldToAndNeverALargerOne) {
  Guard dut = guardWith({{0.15, 0.0}});  // 2 cm ahead
  const Velocity on{0.005, 0.0, 0.0};
  EXPECT_EQ(dut.allowed(on), Velocity{});
  dut.keep(0.01);
  EXPECT_EQ(dut.allowed(on), on);
  dut.keep(1.0);
  EXPECT_EQ(dut.allowed(on), Velocity{});
  const Velocity away{-0.01, 0.0, 0.0};
  EXPECT_EQ(dut.allowed(away), away);
}

TEST(Guard, RetreatsStraightAwayFromTheNearest) {
  const Velocity velocity = guardWith({{0.15, 0.0}, {0.0, 0.3}}).retreat(0.02);
  EXPECT_DOUBLE_EQ(velocity.x_mps, -0.02);
  EXPECT_DOUBLE_EQ(velocity.y_mps, 0.0);
}

}  // namespace
}  // namespace underway
