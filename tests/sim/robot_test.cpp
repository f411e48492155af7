#include "sim/robot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry/random_world.hpp"

namespace underway::sim {
namespace {

std::shared_ptr<const Robot> robotWith(bool has_head, bool has_waist = true) {
  Robot robot = *test::smallRobot();
  if (has_waist) robot.senses.waist = LidarSense{0.3};
  if (has_head) robot.senses.head = LidarSense{0.15};
  return std::make_shared<const Robot>(robot);
}

std::shared_ptr<const World> roomWith(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(
      *World::make("room", {{-5, -5, 0}, 10, 10}, 0.0, std::move(obstacles)));
}

Command forward(double speed_mps) { return {{speed_mps, 0.0, 0.0}, std::nullopt}; }

TEST(SimulatedRobot, DoesTheSameAgainWithTheSameSeedAndOtherwiseWithAnother) {
  const auto run = [](std::uint64_t seed) {
    SimulatedRobot dut(roomWith({}), robotWith(false), {0, 0, 0}, 0, seed);
    for (int k = 0; k < 100; ++k) static_cast<void>(dut.sense()), dut.step({{0.05, 0.0, 0.1}, std::nullopt});
    return dut.truth().pose;
  };
  EXPECT_EQ(run(5), run(5));
  EXPECT_NE(run(5), run(6));
}

TEST(SimulatedRobot, IsNoFasterThanItsGait) {
  Flaws perfect;
  perfect.drift_rad_per_m = perfect.drift_sigma_rad_per_m = 0.0;
  SimulatedRobot dut(roomWith({}), robotWith(false), {0, 0, 0}, 0, 1, perfect);
  for (int k = 0; k < 100; ++k) dut.step({{10.0, 0.0, 0.0}, std::nullopt});
  EXPECT_NEAR(dut.truth().pose.x, 0.068 * 10.0, 1e-9);
}

TEST(SimulatedRobot, DriftsTwoDegreesPerMetreOnAverageToEitherSide) {
  double sum = 0.0;
  int left = 0;
  constexpr int kRuns = 200;
  for (int seed = 1; seed <= kRuns; ++seed) {
    SimulatedRobot dut(roomWith({}), robotWith(false), {-4, 0, 0}, 0, seed);
    while (dut.truth().moved_m < 1.0) dut.step(forward(0.068));
    const double drift = dut.truth().pose.yaw / dut.truth().moved_m;
    sum += std::abs(drift);
    left += drift > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(sum / kRuns * 180.0 / 3.14159265, 2.0, 0.3);
  EXPECT_NEAR(left, kRuns / 2, 30);
}

TEST(SimulatedRobot, LosesPartOfEveryStroke) {
  double kept = 0.0;
  constexpr int kRuns = 50;
  for (int seed = 1; seed <= kRuns; ++seed) {
    SimulatedRobot dut(roomWith({}), robotWith(false), {0, 0, 0}, 2, seed);
    while (dut.sense().cycles < 10) dut.step(forward(0.025));
    kept += dut.truth().moved_m / (10 * 0.0777) / kRuns;
  }
  EXPECT_NEAR(kept, 0.87, 0.01);
}

TEST(SimulatedRobot, EndsACycleThatItBegan) {
  SimulatedRobot dut(roomWith({}), robotWith(false), {0, 0, 0}, 2, 1);
  dut.step(forward(0.025));
  for (int k = 0; k < 60; ++k) dut.step({});
  EXPECT_EQ(dut.sense().cycles, 1U);
  EXPECT_GT(dut.truth().moved_m, 0.05);
}

TEST(SimulatedRobot, SeesNothingWithItsWaistWhileItLies) {
  SimulatedRobot dut(roomWith({}), robotWith(false), {0, 0, 0}, 0, 1);
  EXPECT_NE(dut.sense().scan, nullptr);
  EXPECT_TRUE(dut.sense().pose.has_value());
  dut.step({{}, ModeId{2}});
  for (int k = 0; k < 100; ++k) dut.step({});
  EXPECT_EQ(dut.sense().mode, 2);
  EXPECT_EQ(dut.sense().scan, nullptr);
  EXPECT_FALSE(dut.sense().pose.has_value());
  EXPECT_TRUE(dut.sense().heading_rad.has_value());
}

TEST(SimulatedRobot, SeesWithItsHeadWhileItLies) {
  SimulatedRobot dut(roomWith({}), robotWith(true), {0, 0, 0}, 2, 1);
  EXPECT_NE(dut.sense().scan, nullptr);
}

TEST(SimulatedRobot, TellsWhereItWasATickAgo) {
  Flaws exact;
  exact.pose_sigma_m = exact.pose_sigma_rad = exact.drift_rad_per_m = exact.drift_sigma_rad_per_m = 0.0;
  SimulatedRobot dut(roomWith({}), robotWith(false), {0, 0, 0}, 0, 1, exact);
  for (int k = 0; k < 10; ++k) {
    const Pose before = dut.truth().pose;
    dut.step(forward(0.068));
    EXPECT_EQ(dut.sense().pose->pose, before);
    EXPECT_NEAR(dut.sense().now_s - dut.sense().pose->stamp_s, 0.1, 1e-9);
  }
}

TEST(SimulatedRobot, KnowsExactlyWhenItTouches) {
  Flaws exact;
  exact.drift_rad_per_m = exact.drift_sigma_rad_per_m = 0.0;
  const Obstacle wall{"wall", {{1.05, 0.0, 0.5}, {0.1, 2.0, 1.0}, {}}};
  SimulatedRobot dut(roomWith({wall}), robotWith(false), {0.0, 0.0, 0.0}, 0, 1, exact);
  while (!dut.truth().has_collided) dut.step(forward(0.068));
  // The body ends .13 m before its middle, the wall begins at 1 m; a tick is 6.8 mm.
  EXPECT_GE(dut.truth().pose.x, 0.87);
  EXPECT_LT(dut.truth().pose.x, 0.877);
  EXPECT_EQ(dut.truth().with, "wall");
}

TEST(SimulatedRobot, TouchesALowTableOnlyStandingOrGettingUp) {
  const Obstacle top{"top", {{0.0, 0.0, 0.32}, {0.5, 2.0, 0.04}, {}}};
  SimulatedRobot lying(roomWith({top}), robotWith(false), {0, 0, 0}, 2, 1);
  for (int k = 0; k < 50; ++k) lying.step(forward(0.025));
  EXPECT_FALSE(lying.truth().has_collided);
  SimulatedRobot standing(roomWith({top}), robotWith(false), {0, 0, 0}, 0, 1);
  EXPECT_TRUE(standing.truth().has_collided);
  SimulatedRobot rising(roomWith({top}), robotWith(false), {0, 0, 0}, 2, 1);
  rising.step({{}, ModeId{0}});
  EXPECT_TRUE(rising.truth().has_collided);
}

TEST(SimulatedRobot, StaysWhereItFell) {
  SimulatedRobot dut(roomWith({}), robotWith(false), {0, 0, 0}, 0, 1);
  dut.fall();
  for (int k = 0; k < 10; ++k) dut.step(forward(0.068));
  EXPECT_EQ(dut.truth().pose, (Pose{0, 0, 0}));
  EXPECT_TRUE(dut.sense().has_fallen);
}

}  // namespace
}  // namespace underway::sim
