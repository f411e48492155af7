#include "local/godzila/heading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bench/minimiser.hpp"
#include "local/godzila/drive.hpp"

namespace underway {
namespace {

Scan emptyScan() {
  Scan scan;
  scan.ranges_m.assign(scan.beams.count, Scan::kNothing);
  return scan;
}

/// A wall across the way, so far ahead.
Scan wallAhead(double range_m) {
  Scan scan = emptyScan();
  for (std::size_t i = 0; i < scan.beams.count; ++i)
    if (const double c = std::cos(scan.beams.bearing(i)); c > 0.2)
      scan.ranges_m[i] = static_cast<float>(range_m / c);
  return scan;
}

TEST(Heading, IsThatOfANumericalMinimiserOfTheCosts) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const auto any = bench::randomHeadingCase(seed);
    const HeadingOptimum dut(any.settings, any.scan.beams);
    const double heading = dut.of(any.scan, any.goal, any.facing_rad).heading_rad;
    const double searched = bench::leastCostHeading(any.scan, any.goal, any.facing_rad, any.settings);
    ASSERT_LT(std::abs(normalizedAngle(heading - searched)), 1e-6) << "seed " << seed;
  }
}

TEST(Heading, IsTheGoalsWhereNothingStands) {
  GodzilaSettings settings = tuned();
  settings.obstacle_attraction = 0.0;
  settings.inertia = 0.0;
  const HeadingOptimum dut(settings, Beams{});
  for (const double bearing : {-3.0, -1.0, 0.0, 0.7, 2.9})
    EXPECT_NEAR(dut.of(emptyScan(), {2.0, bearing}).heading_rad, bearing, 1e-12);
}

TEST(Heading, TurnsAwayFromAPostBesideTheWay) {
  Scan scan = emptyScan();
  for (std::size_t i = 0; i < scan.beams.count; ++i)
    if (std::abs(scan.beams.bearing(i) - 0.3) < 0.1) scan.ranges_m[i] = 0.5F;
  EXPECT_LT(HeadingOptimum(tuned(), scan.beams).of(scan, {3.0, 0.0}).heading_rad, -0.1);
}

TEST(Heading, DoesNotDependOnWhichWayTheRobotFacesWhenAllIsTurnedWithIt) {
  // Sideways form: the scene turned by a quarter, and so is what is ahead.
  const double quarter = 0.5 * std::numbers::pi;
  Scan ahead = emptyScan();
  Scan left = emptyScan();
  const auto shift = static_cast<std::size_t>(std::lround(quarter / ahead.beams.step_rad));
  const double turned = static_cast<double>(shift) * ahead.beams.step_rad;
  for (std::size_t i = 0; i + shift < ahead.beams.count; ++i)
    if (std::abs(ahead.beams.bearing(i) - 0.2) < 0.25) ahead.ranges_m[i] = left.ranges_m[i + shift] = 0.6F;
  GodzilaSettings settings = tuned();
  settings.obstacle_attraction = 0.0;  // beams that see nothing are not turned with the scene
  const HeadingOptimum dut(settings, ahead.beams);
  EXPECT_NEAR(dut.of(left, {2.0, turned}, turned).heading_rad,
              dut.of(ahead, {2.0, 0.0}, 0.0).heading_rad + turned, 1e-6);
}

TEST(Heading, TellsTheNearestBeam) {
  Scan scan = emptyScan();
  scan.ranges_m[100] = 0.8F;
  const auto result = HeadingOptimum(tuned(), scan.beams).of(scan, {2.0, 0.0});
  EXPECT_FLOAT_EQ(static_cast<float>(result.nearest_m), 0.8F);
  EXPECT_DOUBLE_EQ(result.nearest_rad, scan.beams.bearing(100));
}

TEST(Drive, IsSlowerNearAWallAndWhileTurning) {
  const SpeedLimits limits{0.068, 0.04, 0.04, 0.04, 0.17};
  const HeadingOptimum::Result straight{{1.0, 0.0}, 0.0, 0.6, 0.0};
  HeadingOptimum::Result turning = straight;
  turning.heading_rad = 1.0;
  HeadingOptimum::Result near = turning;
  near.nearest_m = 0.25;
  const double free = velocityTowards(straight, tuned(), limits).x_mps;
  GodzilaSettings papers = table7();
  papers.most_speed = 1.0;
  papers.most_turn = 1.0;
  const double while_turning = velocityTowards(turning, papers, limits).x_mps;
  const double near_and_turning = velocityTowards(near, papers, limits).x_mps;
  EXPECT_NEAR(free, limits.forward_mps, 1e-12);
  EXPECT_LT(while_turning, free);
  EXPECT_LT(near_and_turning, while_turning);
}

TEST(Drive, KeepsToItsSharesOfTheTopSpeeds) {
  const SpeedLimits limits{0.068, 0.04, 0.04, 0.04, 0.17};
  const HeadingOptimum::Result free{{1.0, 0.0}, 0.0, 5.0, 0.0};
  HeadingOptimum::Result behind = free;
  behind.heading_rad = 3.0;
  EXPECT_DOUBLE_EQ(velocityTowards(free, table7(), limits).x_mps, 0.4 * limits.forward_mps);
  EXPECT_DOUBLE_EQ(velocityTowards(behind, table7(), limits).turn_radps, 0.2 * limits.turn_radps);
}

TEST(Drive, GoesAlongTheSenseInItsSidewaysForm) {
  const SpeedLimits limits{0.068, 0.04, 0.04, 0.04, 0.17};
  const double left = 0.5 * std::numbers::pi;
  const HeadingOptimum::Result optimum{{0.0, 1.0}, left, 3.0, 0.0};
  const Velocity velocity = velocityTowards(optimum, tuned(), limits, left);
  EXPECT_NEAR(velocity.x_mps, 0.0, 1e-12);
  EXPECT_NEAR(velocity.y_mps, limits.left_mps, 1e-9);
  EXPECT_NEAR(velocity.turn_radps, 0.0, 1e-12);
}

TEST(Settings, OfTableSevenAreThePapers) {
  const GodzilaSettings dut = table7();
  EXPECT_EQ(dut.goal_stopping_radius_m, 0.3);
  EXPECT_EQ(dut.least_speed, -0.4);
  EXPECT_EQ(dut.most_speed, 0.4);
  EXPECT_EQ(dut.least_turn, -0.2);
  EXPECT_EQ(dut.most_turn, 0.2);
  EXPECT_EQ(dut.clearance_threshold_m, 0.3);
  EXPECT_EQ(dut.obstacle_threshold_m, 3.0);
  EXPECT_EQ(dut.goal_attraction, 100.0);
  EXPECT_EQ(dut.obstacle_repulsion, 20.0);
  EXPECT_EQ(dut.obstacle_attraction, 0.0);
  EXPECT_EQ(dut.bearing_ratio, 1.0);
  EXPECT_EQ(dut.inertia, 15.0);
  EXPECT_EQ(dut.velocity_gain, 5.0);
  EXPECT_EQ(dut.forward_repulsion, 5.0);
  EXPECT_EQ(dut.turn_braking, 3.0);
}

TEST(Heading, StaysAheadOfAWallThatIsSquare) {
  // The degenerate case of the thesis' figure 41: nothing tells left from right.
  const Scan scan = wallAhead(0.5);
  const double heading = HeadingOptimum(tuned(), scan.beams).of(scan, {3.0, 0.0}).heading_rad;
  EXPECT_LT(std::min(std::abs(heading), std::numbers::pi - std::abs(heading)), 1e-3);
}

}  // namespace
}  // namespace underway
