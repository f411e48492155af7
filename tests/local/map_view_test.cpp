#include "local/map_view.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "geometry/layer.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

/// What is told block by block is the same as each cell asked by itself.
TEST(MapView, ExpectsWhatStandsNearEachCellAndNothingElse) {
  constexpr unsigned kSeed = 9;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> at(0.0, 12.0);
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 25; ++i)
    obstacles.push_back(
        {"box " + std::to_string(i), {{at(random), at(random), 0.3}, {0.2, 0.1, 0.6}, {0, 0, at(random)}}});
  const World world = *World::make("room", {{0, 0, 0}, 12, 12}, 0.0, obstacles);
  const Plan plan =
      timedPlan({{translate(0, Sense::kForward, {2.0, 2.0, 0.7}, 8.0), 100.0, {}}}, {2.0, 2.0, 0.7});
  const Tolerance tolerance;
  const MapView dut(world, {0.3, 0.3}, plan, tolerance, 1.0);
  const Layer seen = Layer::seenIn({0.3, 0.3}, world.obstacles());
  int expected = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Point end{plan.segments[0].motion.to.x, plan.segments[0].motion.to.y};
    const Point p{std::uniform_real_distribution<double>(1.1, end.x + 0.9)(random),
                  std::uniform_real_distribution<double>(1.1, end.y + 0.9)(random)};
    constexpr double kCell_m = MapView::kCell_m;  // what it is told for is the middle of a point's cell
    if (seen.touches(p, tolerance.near_m - kCell_m)) {
      ASSERT_TRUE(dut.isExpected(p, 0.5)) << p.x << " " << p.y << " seed " << kSeed;
      ++expected;
    }
    if (!seen.touches(p, tolerance.near_m + kCell_m)) {
      ASSERT_FALSE(dut.isExpected(p, 0.5)) << p.x << " " << p.y << " seed " << kSeed;
    }
    if (!seen.touches(p, tolerance.far_m + kCell_m)) {
      ASSERT_FALSE(dut.isExpected(p, 2.0)) << p.x << " " << p.y << " seed " << kSeed;
    }
  }
  EXPECT_GT(expected, 100);
}

}  // namespace
}  // namespace underway
