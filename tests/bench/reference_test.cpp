#include "bench/reference.hpp"

#include <gtest/gtest.h>

#include <numbers>

/// The reference decides who is right, so what it says is held against numbers known by hand.
namespace underway::bench {
namespace {

constexpr double kPi = std::numbers::pi;

const Prism kBody{{0.0, 0.0, 0.0}, {-0.5, 0.5}, {-0.5, 0.5}, {0.0, 1.0}};

TEST(ReferenceSeparation, OfBoxesSideBySideIsTheirGapAndOfOverlappingOnesTheWayOut) {
  EXPECT_NEAR(reference::separation(kBody, {{1.2, 0.0, 0.5}, {1.0, 1.0, 1.0}, {}}), 0.2, 1e-15);
  EXPECT_NEAR(reference::separation(kBody, {{0.9, 0.0, 0.5}, {1.0, 1.0, 1.0}, {}}), -0.1, 1e-15);
  EXPECT_NEAR(reference::separation(kBody, {{0.0, 0.0, 1.8}, {1.0, 1.0, 1.0}, {}}), 0.3, 1e-15);
}

TEST(ReferenceSeparation, KnowsAnEdgeThatPointsAtAFace) {
  // A cube turned by 45 degrees: its edge is half its diagonal ahead of its middle.
  const double half_diagonal = 0.5 * std::numbers::sqrt2;
  EXPECT_NEAR(
      reference::separation(kBody, {{0.6 + half_diagonal, 0.0, 0.5}, {1.0, 1.0, 1.0}, {0, 0, kPi / 4}}), 0.1,
      1e-12);
}

TEST(ReferenceSeparation, KnowsEdgesThatCrossInSpace) {
  // Two bars, each on edge, cross at right angles: only the axis across both edges tells them apart.
  const Prism bar{{0.0, 0.0, kPi / 4}, {-0.1, 0.1}, {-0.1, 0.1}, {-2.0, 2.0}};
  const double half_diagonal = 0.1 * std::numbers::sqrt2;
  const OrientedBox other{{2.0 * half_diagonal + 0.01, 0.0, 0.0}, {0.2, 4.0, 0.2}, {0.0, kPi / 4, 0.0}};
  EXPECT_NEAR(reference::separation(bar, other), 0.01, 1e-12);
}

TEST(ReferenceShadow, OfALeaningBoardEndsWhereTheSlabCutsIt) {
  const OrientedBox board{{0.5, 0.0, 0.5}, {std::numbers::sqrt2, 1.0, 1e-9}, {0.0, -kPi / 4, 0.0}};
  double furthest = -1.0;
  for (const Point corner : reference::shadow(board, {0.005, 0.2})) furthest = std::max(furthest, corner.x);
  EXPECT_NEAR(furthest, 0.2, 1e-8);
  EXPECT_TRUE(reference::shadow(board, {1.1, 1.2}).empty());
}

TEST(ReferenceDistance, IsKnownBetweenSquares) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_NEAR(reference::distance(square, {{4, 5}, {5, 5}, {5, 6}, {4, 6}}), 5.0, 1e-12);
  EXPECT_EQ(reference::distance(square, {{0.5, 0.5}, {2, 0.5}, {2, 2}}), 0.0);
}

TEST(ReferenceDistanceOfTurn, OfAPostBesideTheCornersCircleIsTheRestOfTheWay) {
  const std::vector<Point> post{{-0.01, 0.8}, {0.01, 0.8}, {0.01, 0.9}, {-0.01, 0.9}};
  const double reach = 0.5 * std::numbers::sqrt2;  // of a corner, which passes below the post
  const auto dut = reference::distanceOfTurn(kBody, kPi / 2, post, 1e-6, 10.0);
  EXPECT_NEAR(dut.at_most_m, 0.8 - reach, 1e-6);
  EXPECT_LE(dut.at_least_m, 0.8 - reach);
  EXPECT_GE(dut.at_least_m, dut.at_most_m - 2e-6);
}

TEST(ReferenceDistanceOfTurn, IsZeroWhenAPostIsHitOnTheWayOnly) {
  const std::vector<Point> post{{-0.01, 0.6}, {0.01, 0.6}, {0.01, 0.9}, {-0.01, 0.9}};
  EXPECT_EQ(reference::distanceOfTurn(kBody, kPi / 2, post, 1e-6, 10.0).at_most_m, 0.0);
  EXPECT_GT(reference::distanceOfTurn(kBody, 0.1, post, 1e-6, 10.0).at_least_m, 0.01);
}

}  // namespace
}  // namespace underway::bench
