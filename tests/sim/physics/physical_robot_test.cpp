#include "sim/physics/physical_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "local/mission.hpp"
#include "planner/planner.hpp"
#include "tests/planner/fixture.hpp"
#include "tests/sim/physics/nao_simulation.hpp"

namespace underway::physics {
namespace {

constexpr ModeId kCrawl = 2;

World roomWith(std::vector<Obstacle> obstacles) {
  return *World::make("room", {{0.0, 0.0, 0.0}, 4.0, 2.0}, 0.0, std::move(obstacles));
}

PhysicalRobot standingIn(const World& world, const Pose& start) {
  return PhysicalRobot::make(kRobot, world, test::nao(), start, gait::cruiseGait(), conditionsOf(9)).value();
}

TEST(PhysicalRobot, WalksWhereItIsToldOnItsFeet) {
  PhysicalRobot dut = standingIn(roomWith({}), {1.0, 1.0, 0.5});
  for (int tick = 0; tick < 50; ++tick) dut.step({{0.05, 0.0, 0.0}, {}});
  const Pose made = relative({1.0, 1.0, 0.5}, dut.truth().pose);
  EXPECT_NEAR(made.x, 0.25, 0.01);
  EXPECT_NEAR(made.y, 0.0, 0.02);
  EXPECT_TRUE(dut.truth().is_upright);
  EXPECT_TRUE(dut.truth().touches.empty());
  for (int tick = 0; tick < 50; ++tick) dut.step({{0.0, 0.0, 0.1}, {}});
  EXPECT_NEAR(normalizedAngle(dut.truth().pose.yaw - 0.5), 0.5, 0.04);
  EXPECT_TRUE(dut.truth().is_upright);
}

TEST(PhysicalRobot, TouchesWhatItIsWalkedInto) {
  const World world = roomWith({{"post", {{1.5, 1.0, 0.3}, {0.1, 0.1, 0.6}, {}}}});
  PhysicalRobot dut = standingIn(world, {1.0, 1.0, 0.0});
  for (int tick = 0; tick < 80; ++tick) dut.step({{0.06, 0.0, 0.0}, {}});
  EXPECT_FALSE(dut.truth().touches.empty());
}

TEST(PhysicalRobot, TellsFromItsSensesWhatItsGaitDoes) {
  PhysicalRobot dut = standingIn(roomWith({}), {1.0, 1.0, 0.0});
  EXPECT_NE(dut.sense().scan, nullptr);
  dut.step({{}, kCrawl});
  EXPECT_TRUE(dut.sense().is_switching);
  EXPECT_EQ(dut.sense().scan, nullptr) << "the lidar at the waist looks at the floor";
  for (int tick = 0; tick < 140; ++tick) dut.step({});
  EXPECT_EQ(dut.sense().mode, kCrawl);
  EXPECT_FALSE(dut.sense().has_fallen);
  const Pose lying = dut.truth().pose;
  for (int tick = 0; tick < 40; ++tick) dut.step({{tick == 0 ? 0.025 : 0.0, 0.0, 0.0}, {}});
  EXPECT_EQ(dut.sense().cycles, 1U);
  EXPECT_NEAR(relative(lying, dut.truth().pose).x, 0.09, 0.015);
}

TEST(ExecutorInPhysics, CrawlsUnderATableAndGoesOn) {
  const auto world =
      std::make_shared<const World>(roomWith({{"table", {{2.0, 1.0, 0.35}, {0.2, 2.0, 0.1}, {}}}}));
  const auto robot = test::nao();
  Planner planner(world, robot);
  const auto source = [&](const Request& request, const std::shared_ptr<const World>&) {
    return planner.plan(request, Planner::Clock::now() + std::chrono::seconds(5));
  };
  Request request;
  request.start = {1.0, 1.0, 0.0};
  request.goal = {3.4, 1.0};
  request.goal_yaw = 0.0;
  PhysicalRobot body = standingIn(*world, request.start);
  ExecutorSettings settings;
  settings.crawl = crawlSettingsOf(gait::CrawlPlayer::make(gait::naoCrawler(), gait::cruiseGait()).value());
  Mission mission(world, robot, request, source, settings);
  while (mission.outcome() == Mission::Outcome::kUnderway && body.now_s() < 300.0)
    body.step(mission.tick(body.sense()).command);
  EXPECT_EQ(mission.outcome(), Mission::Outcome::kArrived) << mission.why();
  EXPECT_TRUE(body.truth().touches.empty()) << *body.truth().touches.begin();
  EXPECT_LT(distance(body.truth().pose.position(), request.goal), 0.05);
  EXPECT_GT(body.sense().cycles, 5U);
}

}  // namespace
}  // namespace underway::physics
