#include "geometry/turning_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

/// A point as seen from a box's frame.
Point seenFrom(const Pose& frame, Point point) {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  const Point off{point.x - frame.x, point.y - frame.y};
  return {c * off.x + s * off.y, c * off.y - s * off.x};
}

Point turned(Point point, Point pivot, double angle_rad) {
  return transform({pivot.x, pivot.y, angle_rad}, {point.x - pivot.x, point.y - pivot.y});
}

TEST(TurningPoints, FitIntoTheirBoxThroughoutTheTurnAndTouchItsSides) {
  constexpr unsigned kSeed = 1;
  constexpr int kSamples = 2000;
  test::RandomWorld random(kSeed);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    const auto any = [&] { return Point{random.between(-1.0, 1.0), random.between(-1.0, 1.0)}; };
    const Point pivot = any();
    const std::vector<Point> points{any(), any(), any(), any()};
    const double first = random.between(-7.0, 7.0);
    const Range angles{first, first + random.between(0.0, 6.5)};
    const Prism box = TurningPoints(points, pivot).boxAround(angles, random.angle(), {0.0, 1.0});
    Range x{1e9, -1e9};
    Range y{1e9, -1e9};
    for (int i = 0; i <= kSamples; ++i) {
      for (const Point point : points) {
        const Point at =
            seenFrom(box.frame, turned(point, pivot, angles.min + angles.length() * i / kSamples));
        x = hull(x, {at.x, at.x});
        y = hull(y, {at.y, at.y});
      }
    }
    constexpr double kRounding_m = 1e-12;
    constexpr double kBetweenSamples_m = 2e-5;
    for (const auto& [seen, side] : {std::pair{x, box.x}, std::pair{y, box.y}}) {
      ASSERT_GE(seen.min, side.min - kRounding_m);
      ASSERT_LE(seen.max, side.max + kRounding_m);
      ASSERT_LE(seen.min, side.min + kBetweenSamples_m);
      ASSERT_GE(seen.max, side.max - kBetweenSamples_m);
    }
  }
}

TEST(TurningPoints, FillACircleInAFullTurn) {
  const TurningPoints dut(std::vector<Point>{{3.0, 2.0}, {1.5, 2.0}}, {1.0, 2.0});
  EXPECT_DOUBLE_EQ(dut.reach(), 2.0);
  const Prism box = dut.boxAround({0.0, 6.3}, 0.7, {0.0, 1.0});
  for (const Range& side : {box.x, box.y}) {
    EXPECT_DOUBLE_EQ(side.min, -2.0);
    EXPECT_DOUBLE_EQ(side.max, 2.0);
  }
}

}  // namespace
}  // namespace underway
