// The player itself: a robot that keeps still, the same motion from the same seed, limits of servos.

#include "sim/physics/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/gait.hpp"
#include "gait/crawl/switches.hpp"
#include "sim/physics/picture.hpp"
#include "tests/sim/physics/nao_simulation.hpp"

namespace underway::physics {
namespace {

const gait::JointTable& crawl() {
  static const gait::JointTable table = gait::crawlMotion(gait::naoCrawler(), gait::nominalGait()).value();
  return table;
}

TEST(Simulation, ANaoThatStandsKeepsStanding) {
  Simulation dut = nao(conditionsOf(9));
  dut.start(gait::standing(crawl()), Posture::kStanding, {1.0, 2.0, 0.5});
  const Pose put = dut.now().standing;
  EXPECT_NEAR(put.x, 1.0, 0.01);
  EXPECT_NEAR(put.y, 2.0, 0.01);
  EXPECT_NEAR(put.yaw, 0.5, 0.02);
  const Recording recording = dut.hold(3.0, Posture::kStanding);
  const Pose now = relative(put, dut.now().standing);
  EXPECT_LT(std::hypot(now.x, now.y), 1e-3);
  EXPECT_LT(std::abs(dut.now().pitch_rad), 0.05);
  EXPECT_TRUE(recording.touches.empty());
  EXPECT_TRUE(recording.self_touches.empty());
}

TEST(Simulation, TheSameSeedGivesTheSameMotionBitForBit) {
  std::vector<double> ends[2];
  for (auto& end : ends) {
    Simulation dut = nao(conditionsOf(4));
    dut.start(crawl(), Posture::kLying, {});
    dut.play(crawl(), Posture::kLying);
    end = dut.now().positions;
  }
  EXPECT_EQ(ends[0], ends[1]);
}

TEST(Simulation, NoServoGivesMoreTorqueThanItHas) {
  Simulation dut = nao(conditionsOf(4));
  dut.start(crawl(), Posture::kLying, {});
  const Recording recording = dut.play(crawl(), Posture::kLying);
  EXPECT_LE(recording.efforts.at("LShoulderPitch").peak_nm, 1.329 + 1e-9);
  EXPECT_LE(recording.efforts.at("LKneePitch").peak_nm, 3.023 + 1e-9);
  EXPECT_GT(recording.efforts.at("LKneePitch").square_nm2s, 0.0);
}

TEST(Simulation, AJumpInATableIsFollowedNoFasterThanTheServoCan) {
  constexpr double kSpeed_radps = 8.26797;
  constexpr double kPlayed_s = 0.1;
  Simulation dut = nao({});
  dut.start(gait::standing(crawl()), Posture::kStanding, {});
  const double before = dut.angle("LShoulderPitch");
  gait::JointTable jump({"LShoulderPitch"});
  jump.append(0.0, std::array{before - 1.5});
  jump.append(kPlayed_s, std::array{before - 1.5});
  dut.play(jump, Posture::kStanding);
  EXPECT_LT(dut.angle("LShoulderPitch"), before - 0.1);
  EXPECT_GT(dut.angle("LShoulderPitch"), before - kSpeed_radps * kPlayed_s);
}

TEST(Simulation, ATableWithAnotherRobotsJointIsRefused) {
  gait::JointTable table({"TailPitch"});
  table.append(0.0, std::array{0.0});
  Simulation dut = nao({});
  EXPECT_THROW(dut.play(table, Posture::kStanding), std::invalid_argument);
}

TEST(Simulation, WhatTouchesAnObstacleIsTold) {
  // A beam under the outstretched head of a robot that folds.
  Simulation dut = nao({}, {.ground = {}, .obstacles = {{{0.2, 0.0, 0.2}, {0.1, 1.0, 0.4}, {}}}});
  const gait::JointTable down = gait::goDown(crawl());
  dut.start(down, Posture::kStanding, {});
  const Recording recording = dut.play(down, Posture::kStanding);
  EXPECT_FALSE(recording.touches.empty());
  EXPECT_TRUE(recording.touches.begin()->ends_with(" on obstacle 0")) << *recording.touches.begin();
}

TEST(DrawSide, ShowsEverySampleWithItsTime) {
  Simulation dut = nao({});
  dut.start(crawl(), Posture::kLying, {});
  const std::string svg = drawSide(dut.model(), spread(dut.play(crawl(), Posture::kLying), 4));
  EXPECT_EQ(svg.rfind("<svg", 0), 0U);
  EXPECT_NE(svg.find(">0.00 s, highest"), std::string::npos);
  EXPECT_NE(svg.find(">3."), std::string::npos);
}

}  // namespace
}  // namespace underway::physics
