#include "local/command.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/map.hpp"
#include "local/hold.hpp"

namespace underway {
namespace {

const SpeedLimits kLimits{0.068, 0.04, 0.04, 0.03, 0.17};

TEST(SpeedLimits, OfNaoAreThoseOfItsTwoStandingModes) {
  const auto nao = readRobot(UNDERWAY_SOURCE_DIR "/robots/nao.yaml");
  ASSERT_TRUE(nao.has_value());
  const SpeedLimits dut = standingLimits(*nao);
  EXPECT_EQ(dut.forward_mps, nao->modes[0].speed(Sense::kForward));
  EXPECT_EQ(dut.backward_mps, nao->modes[0].speed(Sense::kBackward));
  EXPECT_EQ(dut.left_mps, nao->modes[1].speed(Sense::kLeft));
  EXPECT_EQ(dut.right_mps, nao->modes[1].speed(Sense::kRight));
  EXPECT_EQ(dut.turn_radps, nao->modes[0].turn_speed_radps);
}

TEST(Limited, LeavesWhatIsInsideAlone) {
  const Velocity wanted{0.03, -0.01, -0.1};
  EXPECT_EQ(limited(wanted, kLimits), wanted);
}

TEST(Limited, KeepsTheDirectionAndEndsOnTheEllipse) {
  for (double angle = 0.0; angle < 6.28; angle += 0.1) {
    const Velocity dut = limited({std::cos(angle), std::sin(angle), 5.0}, kLimits);
    EXPECT_NEAR(std::remainder(std::atan2(dut.y_mps, dut.x_mps) - angle, 2.0 * std::numbers::pi), 0.0, 1e-12);
    const double x = dut.x_mps / (dut.x_mps > 0 ? kLimits.forward_mps : kLimits.backward_mps);
    const double y = dut.y_mps / (dut.y_mps > 0 ? kLimits.left_mps : kLimits.right_mps);
    EXPECT_NEAR(std::hypot(x, y), 1.0, 1e-12);
    EXPECT_EQ(dut.turn_radps, kLimits.turn_radps);
  }
}

TEST(Limited, StopsWhatTheRobotCannotDo) {
  const Velocity dut = limited({0.0, 0.1, 0.0}, {0.068, 0.04, 0.0, 0.0, 0.17});
  EXPECT_NEAR(dut.y_mps, 0.0, 1e-9);
}

TEST(Hold, BringsTheRobotToAPoseAndKeepsItThere) {
  Pose at{0.3, -0.2, 2.0};
  const Pose target{0.0, 0.1, -2.5};
  for (int k = 0; k < 400; ++k) {
    const Velocity v = holdAt(target, at, {}, kLimits);
    at = compose(at, {0.1 * v.x_mps, 0.1 * v.y_mps, 0.1 * v.turn_radps});
  }
  EXPECT_NEAR(distance(at.position(), target.position()), 0.0, 1e-6);
  EXPECT_NEAR(normalizedAngle(at.yaw - target.yaw), 0.0, 1e-6);
}

TEST(Lane, IsJoinedBeforeItIsFollowed) {
  const Velocity off = alongLane(0.0, 0.05, {0.1, 0.0, 0.01, 0.02}, {}, kLimits);
  EXPECT_EQ(off.x_mps, 0.0);  // ten tolerances beside it: first back
  EXPECT_LT(off.y_mps, 0.0);
  const Velocity on = alongLane(0.0, 0.05, {0.0, 0.0, 0.01, 0.02}, {}, kLimits);
  EXPECT_DOUBLE_EQ(on.x_mps, 0.05);
}

}  // namespace
}  // namespace underway
