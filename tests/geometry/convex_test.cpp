#include "geometry/convex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

std::vector<Point> randomPolygon(test::RandomWorld& random, Point center, double size) {
  std::vector<Point> points;
  for (int i = 0; i < 3 + random.oneOf(8); ++i)
    points.push_back({center.x + random.between(-size, size), center.y + random.between(-size, size)});
  return convexHull(points);
}

bool isInside(const std::vector<Point>& polygon, Point p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < -1e-12) return false;
  }
  return true;
}

/// Points along the outline, a millimetre apart.
std::vector<Point> outline(const std::vector<Point>& polygon) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    const int steps = 1 + static_cast<int>(distance(a, b) / 1e-3);
    for (int k = 0; k < steps; ++k)
      points.push_back({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
  }
  return points;
}

TEST(ConvexHull, HoldsAllPointsAndTurnsLeftAtEachCorner) {
  test::RandomWorld random(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 20; ++k) points.push_back({random.between(0.0, 1.0), random.between(0.0, 1.0)});
    const auto dut = convexHull(points);
    for (const Point p : points) ASSERT_TRUE(isInside(dut, p));
    for (const Point corner : dut) ASSERT_NE(std::find(points.begin(), points.end(), corner), points.end());
  }
}

TEST(ConvexHull, OfPointsInLineIsTheLineAndOfOnePointThePoint) {
  EXPECT_EQ(convexHull({{0, 0}, {1, 1}, {2, 2}, {0.5, 0.5}}).size(), 2U);
  EXPECT_EQ(convexHull({{3, 4}, {3, 4}}).size(), 1U);
  EXPECT_TRUE(convexHull({}).empty());
}

TEST(Gap, IsZeroWhenSetsOverlapOrTouchAndOneHoldsTheOther) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Point> beside{{1, 0.2}, {2, 0.2}, {2, 0.8}, {1, 0.8}};
  const std::vector<Point> within{{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}};
  EXPECT_EQ(gapBetween(square, beside).distance_m, 0.0);
  EXPECT_EQ(gapBetween(square, within).distance_m, 0.0);
  EXPECT_EQ(gapBetween(within, square).distance_m, 0.0);
  EXPECT_EQ(distanceTo(square, {0.5, 0.5}), 0.0);
}

TEST(Gap, OfAPointInLineWithALineIsTheWayToItsEnd) {
  const std::vector<Point> line{{0, 0}, {1, 0}};
  EXPECT_NEAR(distanceTo(line, {100, 0}), 99.0, 2e-9);
  EXPECT_NEAR(distanceTo(line, {-2, 0}), 2.0, 2e-9);
  EXPECT_EQ(distanceTo(line, {0.5, 0}), 0.0);
  EXPECT_NEAR(gapBetween(line, std::vector<Point>{{3, 0}, {4, 0}}).distance_m, 2.0, 2e-9);
}

TEST(Gap, IsKnownBetweenSquares) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Point> beyond{{4, 5}, {5, 5}, {5, 6}, {4, 6}};
  const Gap dut = gapBetween(square, beyond);
  EXPECT_NEAR(dut.distance_m, 5.0, 2e-9);
  EXPECT_EQ(dut.at, (Point{4, 5}));
  const std::vector<Point> line{{2, -1}, {2, 3}};
  EXPECT_NEAR(gapBetween(square, line).distance_m, 1.0, 2e-9);
}

TEST(Gap, EqualsTheLeastDistanceOfOutlinesSampledByTheMillimetre) {
  test::RandomWorld random(2);
  for (int i = 0; i < 300; ++i) {
    const auto a = randomPolygon(random, {0.0, 0.0}, 0.3);
    const auto b = randomPolygon(random, {random.between(0.0, 1.0), random.between(0.0, 1.0)}, 0.3);
    const auto outline_b = outline(b);
    double least = std::numeric_limits<double>::infinity();
    for (const Point p : outline(a))
      for (const Point q : outline_b) least = std::min(least, std::hypot(p.x - q.x, p.y - q.y));
    const bool nested = isInside(a, b[0]) || isInside(b, a[0]);
    const Gap dut = gapBetween(a, b);
    if (nested) {
      ASSERT_EQ(dut.distance_m, 0.0);
    } else if (dut.distance_m == 0.0) {
      ASSERT_LT(least, 1.5e-3);
    } else {
      ASSERT_LE(dut.distance_m, least + 1e-12);
      ASSERT_GE(dut.distance_m, least - 1.5e-3);
      ASSERT_NEAR(distanceTo(b, dut.at), 0.0, 1e-9);
      ASSERT_NEAR(distanceTo(a, dut.at), dut.distance_m, 1e-9);
    }
  }
}

}  // namespace
}  // namespace underway
