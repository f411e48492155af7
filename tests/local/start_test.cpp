#include "local/start.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

constexpr double kHalfPi = 0.5 * std::numbers::pi;

/// Scenario 2a; sideways in the middle of its narrow passage a robot keeps 4 cm.
Checker narrow() { return {test::ourWorld("scenario2a"), test::nao()}; }

TEST(Start, IsWhereTheRobotIsBelievedToStandIfThatKeepsTheMargin) {
  const Pose believed{4.0, 2.015, kHalfPi};
  EXPECT_EQ(startFrom(narrow(), 1, believed), believed);
}

TEST(Start, IsTheNearestPoseThatKeepsTheMarginIfTheBelievedOneDoesNot) {
  const Checker checker = narrow();
  const Pose believed{4.0, 2.031, kHalfPi};  // 9 mm from the wall
  ASSERT_FALSE(checker.isFree(stay(1, believed)));
  const Pose start = startFrom(checker, 1, believed);
  EXPECT_TRUE(checker.isFree(stay(1, start)));
  EXPECT_NEAR(start.y, believed.y - 0.012, 0.002);
  EXPECT_NEAR(start.x, believed.x, 0.012);
}

TEST(Start, IsWhereTheRobotIsBelievedToStandIfNothingNearKeepsTheMargin) {
  const Pose frontally{4.0, 2.0, 0.0};  // too broad for the passage
  EXPECT_EQ(startFrom(narrow(), 0, frontally), frontally);
}

TEST(Start, IsWhereMostIsKeptIfNothingNearKeepsTheMargin) {
  const Checker checker = narrow();
  const Pose turned{4.0, 2.04, kHalfPi - 0.12};  // so far turned that no place in the passage keeps it
  const Pose start = startFrom(checker, 1, turned);
  EXPECT_FALSE(checker.isFree(stay(1, start)));
  EXPECT_GT(checker.clearance(stay(1, start), 0.02), checker.clearance(stay(1, turned), 0.02) + 0.005);
}

TEST(Start, KeepsTheMarginOrMoreThanItDidAndIsNeverFar) {
  const Checker checker = narrow();
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::uniform_real_distribution<double> x(3.6, 4.4);
  std::uniform_real_distribution<double> y(1.7, 2.3);
  std::uniform_real_distribution<double> yaw(-std::numbers::pi, std::numbers::pi);
  int moved = 0;
  for (int i = 0; i < 5000; ++i) {
    const Pose believed{x(random), y(random), yaw(random)};
    const Pose start = startFrom(checker, 1, believed);
    EXPECT_LE(distance(start.position(), believed.position()), 0.02 + 1e-9);
    EXPECT_LE(std::abs(normalizedAngle(start.yaw - believed.yaw)), 0.05 + 1e-9);
    if (start == believed) continue;
    ++moved;
    EXPECT_FALSE(checker.isFree(stay(1, believed)));
    if (checker.isFree(stay(1, start))) continue;
    EXPECT_GT(checker.clearance(stay(1, start), 0.02), checker.clearance(stay(1, believed), 0.02));
  }
  EXPECT_GT(moved, 0);
}

}  // namespace
}  // namespace underway
