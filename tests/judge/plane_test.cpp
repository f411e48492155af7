#include "tests/judge/plane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace judge {
namespace {

const Polygon kUnitSquare{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};

Polygon moved(Polygon polygon, Vec2 by) {
  for (Vec2& corner : polygon) corner = corner + by;
  return polygon;
}

TEST(Distance, SeparatedSquaresAreTheGapApart) {
  EXPECT_DOUBLE_EQ(distance(kUnitSquare, moved(kUnitSquare, {1.25, 0.5})), 0.25);
}

TEST(Distance, DiagonalSquaresAreApartFromCornerToCorner) {
  EXPECT_DOUBLE_EQ(distance(kUnitSquare, moved(kUnitSquare, {1.3, 1.4})), 0.5);
}

TEST(Distance, TouchingIsZero) { EXPECT_EQ(distance(kUnitSquare, moved(kUnitSquare, {1.0, 0.5})), 0.0); }

TEST(Distance, ACrossOfBarsOverlapsThoughNoCornerLiesInside) {
  const Polygon lying{{-2.0, 0.4}, {3.0, 0.4}, {3.0, 0.6}, {-2.0, 0.6}};
  EXPECT_EQ(distance(kUnitSquare, lying), 0.0);
}

TEST(Distance, APolygonInsideAnotherIsAtZeroEitherWay) {
  const Polygon small{{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}};
  EXPECT_EQ(distance(kUnitSquare, small), 0.0);
  EXPECT_EQ(distance(small, kUnitSquare), 0.0);
}

TEST(Distance, LinesAndPointsAreObstaclesToo) {
  EXPECT_DOUBLE_EQ(distance(kUnitSquare, Polygon{{1.5, 0.5}}), 0.5);
  EXPECT_EQ(distance(kUnitSquare, Polygon{{0.5, 0.5}}), 0.0);
  EXPECT_EQ(distance(kUnitSquare, Polygon{{-1.0, 0.5}, {2.0, 0.5}}), 0.0);
}

TEST(ConvexHull, DropsInnerAndRepeatedPointsAndRunsCounterClockwise) {
  const Polygon hull =
      convexHull({{0.5, 0.5}, {1.0, 1.0}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {0.5, 0.0}});
  EXPECT_EQ(hull, kUnitSquare);
}

TEST(ConvexHull, OfCollinearPointsIsTheirLine) {
  EXPECT_EQ(convexHull({{1.0, 1.0}, {0.0, 0.0}, {2.0, 2.0}}), (Polygon{{0.0, 0.0}, {2.0, 2.0}}));
}

TEST(Placed, PutsTheBodyLeftOfAPoseThatLooksUp) {
  const Vec2 left = placed(Pose{1.0, 2.0, std::numbers::pi / 2.0}, Vec2{0.0, 1.0});
  EXPECT_NEAR(left.x, 0.0, 1e-15);
  EXPECT_NEAR(left.y, 2.0, 1e-15);
}

}  // namespace
}  // namespace judge
