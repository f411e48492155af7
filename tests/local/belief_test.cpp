#include "local/belief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace underway {
namespace {

constexpr double kSigma_m = 0.015;
constexpr double kSigma_rad = 0.01745;

/// A robot that walks with a drift that it does not know, and is localised 100 ms late with noise.
class Walk {
 public:
  explicit Walk(std::uint64_t seed, double drift_rad_per_m) : random_(seed), drift_(drift_rad_per_m) {
    dut.set(truth);
  }

  void step(const Velocity& v) {
    Senses senses;
    senses.now_s = now_ += 0.1;
    const Pose then = truth;  // 100 ms ago by then
    const double way = 0.1 * std::hypot(v.x_mps, v.y_mps);
    truth.yaw = normalizedAngle(truth.yaw + 0.1 * v.turn_radps + drift_ * way);
    truth = compose(truth, {0.1 * v.x_mps, 0.1 * v.y_mps, 0.0});
    dut.move(0.1 * v.x_mps, 0.1 * v.y_mps, 0.1 * v.turn_radps);
    senses.pose = PoseEstimate{now_ - 0.1,
                               {then.x + kSigma_m * unit_(random_), then.y + kSigma_m * unit_(random_),
                                normalizedAngle(then.yaw + kSigma_rad * unit_(random_))}};
    dut.correct(senses);
  }

  [[nodiscard]] double off_m() const { return distance(dut.pose().position(), truth.position()); }
  [[nodiscard]] double off_rad() const { return std::abs(normalizedAngle(dut.pose().yaw - truth.yaw)); }

  Belief dut{BeliefSettings{}};
  Pose truth{1.0, 2.0, 3.0};

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> unit_;
  double drift_;
  double now_ = 0.0;
};

TEST(Belief, IsFarNearerToTheTruthThanWhatItIsTold) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Walk walk(seed, 0.035);
    double squares_m = 0.0;
    double squares_rad = 0.0;
    for (int k = 0; k < 600; ++k) {
      walk.step({0.068, 0.0, 0.1 * std::sin(0.02 * k)});
      if (k < 100) continue;
      squares_m += walk.off_m() * walk.off_m();
      squares_rad += walk.off_rad() * walk.off_rad();
    }
    EXPECT_LT(std::sqrt(squares_m / 500), 0.4 * kSigma_m * std::sqrt(2.0)) << "seed " << seed;
    EXPECT_LT(std::sqrt(squares_rad / 500), 0.4 * kSigma_rad) << "seed " << seed;
  }
}

TEST(Belief, LearnsTheDriftOfTheGait) {
  for (const double drift : {-0.06, 0.0, 0.035}) {
    Walk walk(3, drift);
    for (int k = 0; k < 1500; ++k) walk.step({0.068, 0.0, 0.0});
    EXPECT_NEAR(walk.dut.drift(), drift, 0.01);
  }
}

TEST(Belief, DoesNotLagBehindARobotThatIsLocalisedLate) {
  Walk walk(1, 0.0);
  double along = 0.0;
  for (int k = 0; k < 2000; ++k) {
    walk.step({0.068, 0.0, 0.0});
    const Pose back = before({0.0, 0.0, 0.0}, walk.truth);
    if (k >= 100)
      along += transform({back.x, back.y, -walk.truth.yaw}, walk.dut.pose().position()).x / 1900.0;
  }
  EXPECT_LT(std::abs(along), 0.001);  // 7 mm are walked in 100 ms
}

TEST(Belief, JumpsByASwitchAndCountsFixesAnewAfterSilence) {
  Belief dut{BeliefSettings{}};
  dut.set({1.0, 1.0, 0.0});
  dut.jump({0.3, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(dut.pose().x, 1.3);
  Senses silent;
  silent.heading_rad = 0.1;
  dut.correct(silent);
  EXPECT_EQ(dut.fixes(), 0);
  EXPECT_GT(dut.pose().yaw, 0.0);  // the inertial heading still counts
  Senses told;
  told.pose = PoseEstimate{0.0, {1.4, 1.0, 0.0}};
  dut.correct(told);
  EXPECT_EQ(dut.fixes(), 1);
  EXPECT_NEAR(dut.pose().x, 1.35, 1e-9);
}

}  // namespace
}  // namespace underway
