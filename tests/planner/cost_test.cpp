#include "planner/cost.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

TEST(Cost, ComparesTheLastModeFirstAndTheTimeLast) {
  const Cost crawled = Cost::distance(2, 1);
  const Cost sidestepped = Cost::distance(1, 1000000);
  const Cost slow = Cost::time(1ULL << 39);
  EXPECT_GT(crawled, sidestepped + slow);
  EXPECT_GT(sidestepped, slow);
  EXPECT_GT(Cost::distance(4, 1), Cost::distance(3, 4000000));
  EXPECT_EQ(Cost::distance(0, 1000), Cost());
  EXPECT_EQ((crawled + slow).us(), 1ULL << 39);
}

TEST(Cost, OfAMotionIsItsTimeAndByPriorityItsWayInALowerMode) {
  const Robot robot = *test::smallRobot();
  const Motion crawl = translate(2, Sense::kForward, {0, 0, 0}, 0.5);
  EXPECT_EQ(costOf(robot, Policy::kFastest, crawl).us(), 20000001ULL);
  EXPECT_GT(costOf(robot, Policy::kPriority, crawl), Cost::distance(2, 500));
  EXPECT_LT(costOf(robot, Policy::kPriority, crawl), Cost::distance(2, 501));
  const Motion walk = translate(0, Sense::kForward, {0, 0, 0}, 0.5);
  EXPECT_EQ(costOf(robot, Policy::kPriority, walk), costOf(robot, Policy::kFastest, walk));
}

}  // namespace
}  // namespace underway
