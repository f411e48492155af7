#include "planner/proof/core.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/convex.hpp"
#include "geometry/sweep.hpp"
#include "tests/geometry/random_world.hpp"

namespace underway::proof {
namespace {

constexpr double kRounding_m = 1e-12;

Footprint randomFootprint(test::RandomWorld& random) {
  const double x = random.between(-0.5, 0.2);
  const double y = random.between(-0.5, 0.2);
  return {{x, x + random.between(0.05, 0.8)},
          {y, y + random.between(0.05, 0.8)},
          random.oneOf(2) == 0 ? 0.0 : random.between(0.0, 0.05)};
}

Point inBody(Point map, double yaw) {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {c * map.x + s * map.y, c * map.y - s * map.x};
}

/// How far a point is from the footprint without its margin, 0 inside.
double distanceTo(const Footprint& footprint, Point p) {
  const double x = std::max({0.0, footprint.x.min - p.x, p.x - footprint.x.max});
  const double y = std::max({0.0, footprint.y.min - p.y, p.y - footprint.y.max});
  return std::hypot(x, y);
}

TEST(Core, IsCoveredAtEveryHeadingOfItsRange) {
  test::RandomWorld random(1);
  for (int round = 0; round < 2000; ++round) {
    const Footprint footprint = randomFootprint(random);
    const double yaw = random.angle();
    const double half = random.between(0.0, 0.25 * std::numbers::pi);
    const Core dut = coreOf(footprint, yaw, half);
    for (int i = 0; i <= 20; ++i) {
      const double heading = yaw + half * (0.1 * i - 1.0);
      for (const Point corner : dut.common.corners)
        ASSERT_LE(distanceTo(footprint, inBody(corner, heading)), footprint.margin_m + kRounding_m);
    }
  }
}

TEST(Core, ReachesAsFarAsItSaysAndNoFurther) {
  test::RandomWorld random(2);
  for (int round = 0; round < 2000; ++round) {
    const Footprint footprint = randomFootprint(random);
    const double yaw = random.angle();
    const double half = random.between(0.0, 0.25 * std::numbers::pi);
    const Core dut = coreOf(footprint, yaw, half);
    const double heading = yaw + random.between(-half, half);
    const auto bare = Prism{{0, 0, heading}, footprint.x, footprint.y, {}}.footprint();
    const std::vector<Point> around = convexHull(dut.all);
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Point to{std::cos(0.5 * std::numbers::pi * quarter), std::sin(0.5 * std::numbers::pi * quarter)};
      double reach = -1e9;
      for (const Point p : bare) reach = std::max(reach, p.x * to.x + p.y * to.y);
      ASSERT_GE(reach, dut.least[static_cast<std::size_t>(quarter)] - kRounding_m);
      ASSERT_LE(reach, dut.most[static_cast<std::size_t>(quarter)] + kRounding_m);
    }
    const auto grown =
        Prism{{0, 0, heading}, footprint.x, footprint.y, {}}.grown(footprint.margin_m).footprint();
    for (const Point p : grown) ASSERT_LE(underway::distanceTo(around, p), 1e-8);
  }
}

TEST(Core, OfASingleHeadingIsTheWholeBodyButForItsRoundedCorners) {
  const Core dut = coreOf({{-0.13, 0.13}, {-0.195, 0.195}, 0.02}, 0.0, 0.0);
  EXPECT_NEAR(dut.common.reach({1, 0}), 0.15, 1e-12);
  EXPECT_NEAR(dut.common.reach({0, -1}), 0.215, 1e-12);
  EXPECT_NEAR(dut.least[1], 0.195, 1e-12);
}

TEST(Core, LosesOnlyASecondOrderOnTheFlatOfASide) {
  const Core dut = coreOf({{-0.13, 0.13}, {-0.195, 0.195}, 0.02}, 0.0, 0.1);
  EXPECT_GT(dut.common.reach({1, 0}), 0.15 * (1.0 - 0.1 * 0.1 / 2.0));
}

}  // namespace
}  // namespace underway::proof
