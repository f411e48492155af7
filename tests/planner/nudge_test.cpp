#include "planner/nudge.hpp"

#include <gtest/gtest.h>

#include "planner/attach.hpp"
#include "planner/grow.hpp"
#include "planner/search.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using test::requestFor;
using test::soon;

/// The way that a search finds, before any shortening.
class Found {
 public:
  Found(const std::string& map, Policy policy)
      : checker_(std::make_shared<const Checker>(test::ourWorld(map), test::nao())),
        stances_(*checker_, policy) {
    Growth growth(checker_, {1, 3.0});
    for (int i = 0; i < 4; ++i) growth.addBatch();
    roadmap_ = growth.freeze();
  }

  [[nodiscard]] std::optional<Passage> way(const Request& request) const {
    Interrupt never(soon(), {});
    const auto attached = attach(*checker_, stances_, roadmap_, request, Effort::kNearest, never);
    LinkChecks checks(attached->graph, *checker_);
    return search(attached->graph, stances_, checker_->robot(), checks, attached->target, never);
  }
  [[nodiscard]] Nudge nudge(Passage passage) const {
    const double margin_m = checker_->robot().margin_m;
    return {{checker_.get(), stances_.policy(), 0.0, margin_m, margin_m, false, false}, std::move(passage)};
  }
  [[nodiscard]] const Checker& checker() const { return *checker_; }
  [[nodiscard]] Cost costOf(const Route& route) const {
    return underway::costOf(checker_->robot(), stances_.policy(), route);
  }

 private:
  std::shared_ptr<const Checker> checker_;
  Stances stances_;
  Roadmap roadmap_;
};

TEST(Nudge, MakesEveryWayCheaperOrLeavesItAndKeepsItFree) {
  for (const auto& [map, policy] :
       {std::pair{"scenario3", Policy::kPriority}, std::pair{"scenario3", Policy::kFastest},
        std::pair{"scenario2b", Policy::kPriority}}) {
    SCOPED_TRACE(map);
    const Found dut(map, policy);
    auto way = dut.way(requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}));
    ASSERT_TRUE(way.has_value());
    const Cost first = dut.costOf(routeOf(*way));
    Cost cost = way->cost;
    for (const double step_m : {0.3, 0.1, 0.03, 0.01}) {
      Interrupt never(soon(), {});
      Nudge nudge = dut.nudge(std::move(*way));
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
  const Found dut("scenario3", Policy::kFastest);
  auto way = dut.way(requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}));
  ASSERT_TRUE(way.has_value());
  Interrupt never(soon(), {});
  Nudge nudge = dut.nudge(std::move(*way));
  nudge.by(0.1, never);
  const Passage after = std::move(nudge).passage();
  const Passage again = dut.nudge(after).passage();
  EXPECT_EQ(after.cost, again.cost);
}

}  // namespace
}  // namespace underway
