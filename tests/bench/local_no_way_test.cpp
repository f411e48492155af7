#include "bench/local_no_way.hpp"

#include <gtest/gtest.h>

#include "tests/planner/fixture.hpp"

namespace underway::bench {
namespace {

std::shared_ptr<const World> roomWithWall(double length_m) {
  return std::make_shared<const World>(*World::make(
      "room", {{0, 0, 0}, 5, 3}, 0.0, {{"wall", {{2.5, 0.5 * length_m, 0.4}, {0.1, length_m, 0.8}, {}}}}));
}
const Request kAcross = test::requestFor({0.6, 0.6, 0.0}, {4.4, 0.6, 0.0});

TEST(NoWay, IsFalseWhereThereIsOne) {
  EXPECT_EQ(noWay(roomWithWall(2.5), test::nao(), kAcross), NoWay::kFalse);
}

TEST(NoWay, IsProvenWhereAWallLeavesNone) {
  EXPECT_EQ(noWay(roomWithWall(2.9), test::nao(), kAcross), NoWay::kProven);
}

}  // namespace
}  // namespace underway::bench
