#include "planner/gaps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace underway {
namespace {

World roomWith(std::vector<Obstacle> obstacles, Pose corner = {}) {
  return *World::make("room", {corner, 6, 4}, 0.0, std::move(obstacles));
}

constexpr Range kSlab{0.005, 0.585};

/// What a thousand looks find.
std::vector<Gaps::Gap> found(const Gaps& dut) {
  std::mt19937_64 random(1);
  std::vector<Gaps::Gap> gaps;
  for (int i = 0; i < 1000; ++i)
    if (const auto gap = dut.draw(random)) gaps.push_back(*gap);
  return gaps;
}

TEST(Gaps, FindsTheMiddleOfAPassageAndTheWayAcross) {
  // A wall along y with a gap from y = 1.83 to 2.17.
  const World world = roomWith({{"south", {{4.0, 0.915, 0.5}, {0.2, 1.83, 1.0}, {}}},
                                {"north", {{4.0, 3.085, 0.5}, {0.2, 1.83, 1.0}, {}}}});
  const auto gaps = found(Gaps(world, kSlab, 0.5));
  for (const Gaps::Gap& gap : gaps) {
    EXPECT_NEAR(gap.width_m, 0.34, 1e-9);
    EXPECT_NEAR(gap.middle.y, 2.0, 1e-9);
    EXPECT_NEAR(std::abs(gap.across_rad), 1.5707963267948966, 1e-9);
    EXPECT_LE(std::abs(gap.middle.x - 4.0), 0.1 + 1e-9);
  }
  EXPECT_GT(gaps.size(), 100U);
}

TEST(Gaps, FindsTheSameInAMapThatIsTurned) {
  const Pose corner{-3.0, 7.0, 2.0};
  const auto placed = [&](double x, double y) {
    const Point at = transform(corner, {x, y});
    return OrientedBox{{at.x, at.y, 0.5}, {0.2, 1.83, 1.0}, {0.0, 0.0, corner.yaw}};
  };
  const Gaps dut(roomWith({{"south", placed(4.0, 0.915)}, {"north", placed(4.0, 3.085)}}, corner), kSlab,
                 0.5);
  const auto gaps = found(dut);
  for (const Gaps::Gap& gap : gaps) EXPECT_NEAR(gap.width_m, 0.34, 1e-9);
  EXPECT_GT(gaps.size(), 100U);
}

TEST(Gaps, LooksPastWhatDoesNotReachIntoTheSlabAndNotFurtherThanTheWidest) {
  const Obstacle wall{"wall", {{3.0, 2.0, 0.5}, {0.2, 2.0, 1.0}, {}}};
  const Obstacle shelf{"shelf", {{3.4, 2.0, 0.9}, {0.2, 2.0, 0.2}, {}}};   // hangs above the slab
  const Obstacle far_wall{"far", {{5.0, 2.0, 0.5}, {0.2, 2.0, 1.0}, {}}};  // 1.8 m on
  EXPECT_TRUE(found(Gaps(roomWith({wall, shelf, far_wall}), kSlab, 0.6)).empty());
  EXPECT_TRUE(found(Gaps(roomWith({}), kSlab, 0.6)).empty());
}

TEST(Gaps, FindsTheGapBetweenCornersThatNoFaceLooksAcross) {
  // A wall along x that ends where a post on the other side begins.
  const Gaps dut(roomWith({{"wall", {{2.0, 1.5, 0.5}, {1.0, 0.2, 1.0}, {}}},
                           {"post", {{2.6, 2.14, 0.5}, {0.2, 0.2, 1.0}, {}}}}),
                 kSlab, 0.6);
  const auto gaps = found(dut);
  for (const Gaps::Gap& gap : gaps) {
    EXPECT_NEAR(gap.width_m, 0.44, 1e-9);
    EXPECT_NEAR(gap.middle.x, 2.5, 1e-9);
    EXPECT_NEAR(gap.middle.y, 1.82, 1e-9);
    EXPECT_NEAR(std::abs(gap.across_rad), 1.5707963267948966, 1e-9);
  }
  EXPECT_GT(gaps.size(), 10U);
}

TEST(Gaps, FindsTheGapThatAnObstacleLeavesToTheBounds) {
  const Pose corner{-3.0, 7.0, 2.0};
  const Point at = transform(corner, {5.4, 2.0});
  const Gaps dut(roomWith({{"post", {{at.x, at.y, 0.5}, {0.4, 0.4, 1.0}, {0.0, 0.0, corner.yaw}}}}, corner),
                 kSlab, 0.6);
  const auto gaps = found(dut);
  for (const Gaps::Gap& gap : gaps) EXPECT_NEAR(gap.width_m, 0.4, 1e-9);
  EXPECT_GT(gaps.size(), 10U);
}

}  // namespace
}  // namespace underway
