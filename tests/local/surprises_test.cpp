#include "local/surprises.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "local/seen_floor.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

const Pose kStart{0.6, 2.0, 0.0};

TEST(Surprises, BecomeObstaclesAsHighAsTheRobotWhereTheyWereSeen) {
  const auto map = test::ourWorld("scenario3");
  const World world = withSurprises(*map, std::array{Point{1.2, 2.2}, Point{1.26, 2.2}}, Caution{0.06, false},
                                    *test::nao(), 0, kStart);
  EXPECT_EQ(world.obstacles().size(), map->obstacles().size() + 2);
  const Checker checker(std::make_shared<const World>(world), test::nao());
  EXPECT_TRUE(checker.isFree(stay(0, {0.6, 2.0, 0.0})));
  EXPECT_FALSE(checker.isFree(stay(0, {1.2, 2.2, 0.0})));
  EXPECT_FALSE(checker.isFree(stay(2, {1.2, 2.2, 0.0})));
}

TEST(Surprises, AreNotWhereTheRobotStands) {
  const auto map = test::ourWorld("scenario3");
  const World world =
      withSurprises(*map, std::array{Point{0.65, 2.1}}, Caution{0.06, false}, *test::nao(), 0, kStart);
  EXPECT_EQ(world.obstacles().size(), map->obstacles().size());
}

TEST(Surprises, MayGoOnWhereARowOfThemEnds) {
  const auto map = test::ourWorld("scenario3");
  const std::array row{Point{1.2, 2.5}, Point{1.25, 2.5}, Point{1.3, 2.5}, Point{1.35, 2.5}};
  const auto with = [&](bool extends_ends) {
    return withSurprises(*map, row, Caution{0.06, extends_ends}, *test::nao(), 0, kStart).obstacles().size();
  };
  EXPECT_EQ(with(false), map->obstacles().size() + 4);
  EXPECT_EQ(with(true), map->obstacles().size() + 8);  // two beyond each end
}

/// Cells of floor in a square, but for one in its middle row.
std::vector<Point> cellsWithAGap(Point middle, int half) {
  std::vector<Point> cells;
  for (int row = -half; row <= half; ++row)
    for (int column = -half; column <= half; ++column)
      if (row != 0 || column != 0)
        cells.push_back({middle.x + column * SeenFloor::kCell_m, middle.y + row * SeenFloor::kCell_m});
  return cells;
}

TEST(UnseenFloor, BecomesAnObstacleForEachStretchOfARow) {
  const auto map = test::ourWorld("scenario3");
  const World world = withUnseenFloor(*map, cellsWithAGap({1.5, 1.2}, 2), *test::nao(), 0, kStart);
  EXPECT_EQ(world.obstacles().size(), map->obstacles().size() + 6);  // five rows, of which one has a gap
  const Checker checker(std::make_shared<const World>(world), test::nao());
  EXPECT_TRUE(checker.isFree(stay(0, {1.5, 1.2 + 0.195 + 0.05 + 0.05, 0.0})));
  EXPECT_FALSE(checker.isFree(stay(0, {1.5, 1.2 + 0.195 + 0.05, 0.0})));
}

TEST(UnseenFloor, IsNoneWhereTheRobotStandsNorWithinItsMargin) {
  const auto map = test::ourWorld("scenario3");
  const World world = withUnseenFloor(*map, cellsWithAGap(kStart.position(), 20), *test::nao(), 0, kStart);
  EXPECT_GT(world.obstacles().size(), map->obstacles().size());
  EXPECT_TRUE(Checker(std::make_shared<const World>(world), test::nao()).isFree(stay(0, kStart)));
}

/// Scenario 3's plan in a world: in the map alone it lies down at 3.00 m and gets up at 4.60 m.
Plan planIn(const std::shared_ptr<const World>& world) {
  return *Planner(world, test::nao()).plan(test::requestFor(kStart, {5.4, 2.0, 0.0}), test::soon());
}

std::shared_ptr<const World> worldWith(Point seen) {
  return std::make_shared<const World>(withSurprises(*test::ourWorld("scenario3"), std::array{seen},
                                                     Caution{0.06, false}, *test::nao(), 0, kStart));
}

/// Whether the map's plan crawls beside something seen at a point.
bool crawlsBeside(Point seen) {
  return !surprisesBesideCrawl(planIn(test::ourWorld("scenario3")), worldWith(seen), test::nao()).empty();
}

TEST(Surprises, AreToldBesideACrawlAndNotFarFromItOrBesideAWalk) {
  EXPECT_TRUE(crawlsBeside({4.5, 2.3}));
  EXPECT_FALSE(crawlsBeside({4.5, 3.0}));
  EXPECT_FALSE(crawlsBeside({1.5, 2.3}));
}

TEST(Surprises, AreNotBesideTheCrawlOfAPlanThatGivesThemABerth) {
  const auto world = worldWith({4.5, 2.3});
  const auto beside = surprisesBesideCrawl(planIn(test::ourWorld("scenario3")), world, test::nao());
  const Plan wider = planIn(std::make_shared<const World>(withBerth(*world, beside)));
  EXPECT_TRUE(surprisesBesideCrawl(wider, world, test::nao()).empty());
}

TEST(Surprises, GetABerthOnceAndThoseThatAreGoneNone) {
  const auto world = worldWith({4.5, 2.3});
  const std::string id = world->obstacles()[world->obstacles().size() - 1].id;
  const World wider = withBerth(*world, std::array<std::string, 3>{id, id, "seen_0_0"});
  ASSERT_EQ(wider.obstacles().size(), world->obstacles().size());
  EXPECT_NEAR(wider.obstacles()[*wider.obstacles().find(id)].box.size_m.x, 0.26, 1e-9);
}

}  // namespace
}  // namespace underway
