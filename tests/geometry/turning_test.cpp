#include "geometry/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Point> randomPiece(test::RandomWorld& random) {
  std::vector<Point> points;
  const Point about{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
  const double size = random.oneOf(4) == 0 ? 1e-3 : 0.4;
  for (int i = 0; i < 1 + random.oneOf(7); ++i)
    points.push_back({about.x + random.between(-size, size), about.y + random.between(-size, size)});
  return convexHull(points);
}

/// The pivot may lie outside.
Prism randomBody(test::RandomWorld& random) {
  const double x = random.between(-0.5, 0.3);
  const double y = random.between(-0.5, 0.3);
  return {{random.between(-0.2, 0.2), random.between(-0.2, 0.2), random.angle()},
          {x, x + random.between(0.01, 0.6)},
          {y, y + random.between(0.01, 0.6)},
          {0.0, 1.0}};
}

double gapAt(const Prism& body, double turned, ConvexView piece) {
  Prism there = body;
  there.frame.yaw += turned;
  return gapBetween(there.footprint(), piece).distance_m;
}

TEST(Turning, ComesAsNearAsTheNearestOfManyHeadings) {
  test::RandomWorld random(1);
  int touching = 0;
  for (int i = 0; i < 3000; ++i) {
    const Prism body = randomBody(random);
    const std::vector<Point> piece = randomPiece(random);
    const double angle = random.oneOf(5) == 0 ? random.between(-7.0, 7.0) : random.between(-2.0, 2.0);
    const Turning dut(body, angle);
    constexpr int kSteps = 1000;
    double least = 1e9;
    for (int k = 0; k <= kSteps; ++k) least = std::min(least, gapAt(body, angle * k / kSteps, piece));
    const double step = dut.outerRadius() * std::abs(angle) / kSteps;  // that no sample misses by more
    const Gap gap = dut.gapTo(piece);
    ASSERT_EQ(dut.touches(piece), gap.distance_m == 0.0) << "case " << i;
    ASSERT_LE(gap.distance_m, least + 1e-12) << "case " << i;
    ASSERT_GE(gap.distance_m, least - step) << "case " << i;
    if (gap.distance_m > 0.0) {
      ASSERT_LT(distanceTo(piece, gap.at), 1e-9) << "the nearest point lies on the piece, case " << i;
    }
    touching += dut.touches(piece) ? 1 : 0;
  }
  EXPECT_GT(touching, 300);
}

TEST(Turning, ByNothingIsThePose) {
  test::RandomWorld random(2);
  for (int i = 0; i < 2000; ++i) {
    const Prism body = randomBody(random);
    const std::vector<Point> piece = randomPiece(random);
    ASSERT_EQ(Turning(body, 0.0).touches(piece), areTouching(body.footprint(), piece));
    ASSERT_NEAR(Turning(body, 0.0).gapTo(piece).distance_m, gapAt(body, 0.0, piece), 1e-12);
  }
}

TEST(Turning, FurtherMeetsAllThatLessFarMeetsAndComesNoLessNear) {
  test::RandomWorld random(3);
  for (int i = 0; i < 2000; ++i) {
    const Prism body = randomBody(random);
    const std::vector<Point> piece = randomPiece(random);
    const double angle = random.between(-3.0, 3.0);
    const double part = random.between(0.0, 1.0);
    ASSERT_TRUE(!Turning(body, part * angle).touches(piece) || Turning(body, angle).touches(piece));
    ASSERT_GE(Turning(body, part * angle).gapTo(piece).distance_m + 1e-9,
              Turning(body, angle).gapTo(piece).distance_m);
  }
}

TEST(Turning, BackAgainMeetsTheSame) {
  test::RandomWorld random(4);
  for (int i = 0; i < 2000; ++i) {
    const Prism body = randomBody(random);
    const std::vector<Point> piece = randomPiece(random);
    const double angle = random.between(-3.0, 3.0);
    Prism end = body;
    end.frame.yaw += angle;
    ASSERT_NEAR(Turning(body, angle).gapTo(piece).distance_m, Turning(end, -angle).gapTo(piece).distance_m,
                1e-8);
  }
}

TEST(Turning, AllTheWayRoundMeetsAPostThatOnlyACornerReaches) {
  const Prism body{{0, 0, 0}, {-0.3, 0.3}, {-0.1, 0.1}, {0, 1}};
  const double reach = std::hypot(0.3, 0.1);
  for (double direction = 0.0; direction < 2.0 * kPi; direction += 0.37) {
    const auto post = [&](double at) {
      return std::vector<Point>{{at * std::cos(direction), at * std::sin(direction)}};
    };
    EXPECT_TRUE(Turning(body, 2.0 * kPi).touches(post(reach - 1e-7)));
    EXPECT_TRUE(Turning(body, -100.0).touches(post(reach - 1e-7)));
    EXPECT_FALSE(Turning(body, 2.0 * kPi).touches(post(reach + 1e-7)));
    EXPECT_NEAR(Turning(body, 2.0 * kPi).gapTo(post(reach + 0.05)).distance_m, 0.05, 3e-9);
  }
}

TEST(Turning, GrazingTheTangentOfACornersCircleIsACollisionAndAMicrometreOffIsNot) {
  // The corner's circle touches the wall's face in its highest point, half way through the turn.
  const Prism body{{0, 0, 0}, {-0.3, 0.3}, {-0.1, 0.1}, {0, 1}};
  const double reach = std::hypot(0.3, 0.1);
  const auto wall = [&](double at) {
    return std::vector<Point>{{-5.0, at}, {5.0, at}, {5.0, at + 1.0}, {-5.0, at + 1.0}};
  };
  EXPECT_TRUE(Turning(body, kPi / 2.0).touches(wall(reach)));
  EXPECT_FALSE(Turning(body, kPi / 2.0).touches(wall(reach + 1e-6)));
  EXPECT_NEAR(Turning(body, kPi / 2.0).gapTo(wall(reach + 1e-6)).distance_m, 1e-6, 3e-9);
}

TEST(Turning, ThatBeginsAndEndsANanometreFromAWallAndEntersItInBetweenTouches) {
  // The corner's circle bulges into the wall between two headings that hardly miss it.
  for (const double half : {0.05, 0.2, 0.5}) {
    for (const double gap : {1.01e-9, 1.2e-9, 1.4e-9, 2e-9, 3e-9, 1e-8}) {
      const Prism body{{0, 0, -kPi / 4.0 - half}, {-0.3, 0.3}, {-0.3, 0.3}, {0, 1}};
      const double at = 0.3 * std::numbers::sqrt2 * std::cos(half) + gap;
      const std::vector<Point> wall{{at, -5.0}, {at + 1.0, -5.0}, {at + 1.0, 5.0}, {at, 5.0}};
      EXPECT_TRUE(Turning(body, 2.0 * half).touches(wall)) << "gap " << gap << ", half angle " << half;
      EXPECT_EQ(Turning(body, 2.0 * half).gapTo(wall).distance_m, 0.0);
    }
  }
}

TEST(Turning, IsToldRightBesideAWallOfTenKilometres) {
  const Prism body{{3.0, 2.0, 0.3}, {-0.3, 0.3}, {-0.1, 0.1}, {0, 1}};
  const double top = 2.0 - std::hypot(0.3, 0.1);
  const auto wall = [&](double at) {
    return std::vector<Point>{{-5e3, at - 1.0}, {5e3, at - 1.0}, {5e3, at}, {-5e3, at}};
  };
  EXPECT_TRUE(Turning(body, 2.0 * kPi).touches(wall(top + 1e-8)));
  EXPECT_FALSE(Turning(body, 2.0 * kPi).touches(wall(top - 1e-8)));
}

}  // namespace
}  // namespace underway
