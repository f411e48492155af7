#include "planner/nudge.hpp"

#include <gtest/gtest.h>

#include "tests/planner/found_way.hpp"

namespace underway {
namespace {

using test::requestFor;
using test::soon;

Nudge nudgeOn(const test::FoundWay& found, Passage passage) {
  const double margin_m = found.checker().robot().margin_m;
  return {{&found.checker(), found.stances().policy(), 0.0, margin_m, margin_m, false, false},
          std::move(passage)};
}

TEST(Nudge, MakesEveryWayCheaperOrLeavesItAndKeepsItFree) {
  for (const auto& [map, policy] :
       {std::pair{"scenario3", Policy::kPriority}, std::pair{"scenario3", Policy::kFastest},
        std::pair{"scenario2b", Policy::kPriority}}) {
    SCOPED_TRACE(map);
    const test::FoundWay dut(map, policy);
    auto way = dut.way(requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}));
    ASSERT_TRUE(way.has_value());
    const Cost first = dut.costOf(routeOf(*way));
    Cost cost = way->cost;
    for (const double step_m : {0.3, 0.1, 0.03, 0.01}) {
      Interrupt never(soon(), {});
      Nudge nudge = nudgeOn(dut, std::move(*way));
      nudge.by(step_m, never);
      way = std::move(nudge).passage();
      EXPECT_LE(way->cost, cost);
      cost = way->cost;
      const Route route = routeOf(*way);
      ASSERT_FALSE(route.empty());
      for (const Motion& motion : route) EXPECT_TRUE(dut.checker().isFree(motion));
    }
    EXPECT_LT(dut.costOf(routeOf(*way)), first);
  }
}

TEST(Nudge, TellsTheCostThatItsWayHas) {
  const test::FoundWay dut("scenario3", Policy::kFastest);
  auto way = dut.way(requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}));
  ASSERT_TRUE(way.has_value());
  Interrupt never(soon(), {});
  Nudge nudge = nudgeOn(dut, std::move(*way));
  nudge.by(0.1, never);
  const Passage after = std::move(nudge).passage();
  const Passage again = nudgeOn(dut, after).passage();
  EXPECT_EQ(after.cost, again.cost);
}

}  // namespace
}  // namespace underway
