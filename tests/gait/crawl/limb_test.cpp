#include "gait/crawl/limb.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/gait/random_numbers.hpp"

namespace underway::gait {
namespace {

TEST(Limb, InverseIsForwardBackwards) {
  test::RandomNumbers random(1);
  for (int i = 0; i < 100'000; ++i) {
    const Limb limb{{random.between(-0.1, 0.1), random.between(0.0, 0.1)},
                    {random.between(0.05, 0.2), random.between(0.05, 0.2)}};
    const LimbAngles angles{random.between(-3.1, 3.1), random.between(-3.1, 3.1)};
    const PlanePoint end = pointsOf(limb, angles).end;
    const auto roots = reach(limb, end);
    ASSERT_TRUE(roots) << "case " << i;
    for (const LimbAngles& root : {roots->left, roots->right})
      ASSERT_LE(length(pointsOf(limb, root).end - end), 1e-12) << "case " << i;
    const double joint = angles.joint >= 0.0 ? roots->left.joint : roots->right.joint;
    ASSERT_NEAR(joint, angles.joint, 1e-6) << "case " << i;
  }
}

TEST(Limb, FollowsTheThesisFormula) {
  const Limb limb{{0.0, 0.05}, {0.105, 0.11}};
  const PlanePoint end{0.15, 0.0};
  const auto roots = reach(limb, end);
  ASSERT_TRUE(roots);
  // (4.3), and theta1 from (4.4)-(4.7) with both signs of its root.
  const auto [a, b] = limb.m;
  const double x = end.x;
  const double z = end.z - 0.05;
  const double theta2 = std::acos((x * x + z * z - a * a - b * b) / (2.0 * a * b));
  EXPECT_NEAR(roots->left.joint, theta2, 1e-12);
  const double A = x + z + a + b * (std::cos(theta2) + std::sin(theta2));
  const double B = -2.0 * (a + b * (std::cos(theta2) - std::sin(theta2)));
  const double C = x + z - a - b * (std::cos(theta2) + std::sin(theta2));
  const double root = std::sqrt(std::max(0.0, B * B - 4.0 * A * C));
  const double one = 2.0 * std::atan((-B + root) / (2.0 * A));
  const double other = 2.0 * std::atan((-B - root) / (2.0 * A));
  EXPECT_LE(std::min(std::abs(roots->left.root - one), std::abs(roots->left.root - other)), 1e-9);
}

TEST(Limb, OutOfReachIsAValue) {
  const Limb limb{{0.0, 0.0}, {0.1, 0.05}};
  EXPECT_FALSE(reach(limb, {0.16, 0.0}));
  EXPECT_FALSE(reach(limb, {0.04, 0.0}));
  EXPECT_TRUE(reach(limb, {0.149, 0.0}));
}

TEST(Limb, ChoosesTheRootThatStaysOffTheFloor) {
  const Limb limb{{0.0, 0.05}, {0.1, 0.1}};
  const auto roots = reach(limb, {0.15, 0.0});
  ASSERT_TRUE(roots);
  const LimbPoints points = pointsOf(limb, choose(limb, *roots));
  EXPECT_GT(points.joint.z, 0.0);
}

}  // namespace
}  // namespace underway::gait
