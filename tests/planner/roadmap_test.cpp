#include "planner/roadmap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/grow.hpp"
#include "planner/search.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

Roadmap grown(const Checker& checker, std::uint64_t seed, unsigned batches) {
  Growth growth(checker, {seed, 3.0});
  for (unsigned i = 0; i < batches; ++i) growth.addBatch();
  Interrupt never(test::soon(), {});
  return *growth.freeze(never);
}

class GrownRoadmap : public ::testing::TestWithParam<const char*> {
 protected:
  Checker checker{test::ourWorld(GetParam()), test::nao()};
  Roadmap dut = grown(checker, 1, 3);
};

TEST_P(GrownRoadmap, HoldsOnlyFreeMotionsThatItsModesHave) {
  ASSERT_GT(dut.edges.size(), 100U);
  for (Roadmap::NodeId node = 0; node < dut.nodes.size(); ++node) {
    for (const Roadmap::Edge& edge : dut.edgesFrom(node)) {
      const Motion motion = motionOf(dut, *test::nao(), node, edge);
      ASSERT_TRUE(edge.checked);
      ASSERT_TRUE(std::isfinite(duration(*test::nao(), motion)));
      ASSERT_TRUE(checker.isFree(motion));
      ASSERT_EQ(motion.to, dut.node(edge.to).pose);
      ASSERT_EQ(motion.to_mode, dut.node(edge.to).mode);
    }
  }
}

TEST_P(GrownRoadmap, ListsEachPlacesHeadingsCounterClockwise) {
  for (const Roadmap::Place& place : dut.places)
    for (Roadmap::NodeId node = place.first_node; node < place.end_node; ++node) {
      ASSERT_EQ(dut.node(node).pose.position(), place.at);
      if (node == place.first_node) continue;
      ASSERT_GT(dut.node(node).pose.yaw, dut.node(node - 1).pose.yaw);
    }
}

TEST_P(GrownRoadmap, IsTheSameForTheSameSeedAndBatchesAndAnotherForAnotherSeed) {
  const Roadmap again = grown(checker, 1, 3);
  ASSERT_EQ(again.nodes.size(), dut.nodes.size());
  ASSERT_EQ(again.edges.size(), dut.edges.size());
  for (std::size_t i = 0; i < dut.nodes.size(); ++i) ASSERT_EQ(again.nodes[i].pose, dut.nodes[i].pose);
  for (std::size_t i = 0; i < dut.edges.size(); ++i) {
    ASSERT_EQ(again.edges[i].to, dut.edges[i].to);
    ASSERT_EQ(again.edges[i].kind, dut.edges[i].kind);
    ASSERT_EQ(again.edges[i].sense, dut.edges[i].sense);
    ASSERT_EQ(again.edges[i].clockwise, dut.edges[i].clockwise);
  }
  EXPECT_NE(grown(checker, 2, 3).nodes.size(), dut.nodes.size());
}

TEST_P(GrownRoadmap, HasATimeBoundThatIsConsistentOnEveryEdge) {
  const Robot& robot = *test::nao();
  for (const ModeId goal_mode : {ModeId{0}, ModeId{2}}) {
    const TimeBound bound(robot, {5.4, 2.0}, goal_mode);
    for (Roadmap::NodeId node = 0; node < dut.nodes.size(); ++node) {
      const std::uint64_t here = bound.us(dut.node(node).pose.position(), dut.node(node).mode);
      for (const Roadmap::Edge& edge : dut.edgesFrom(node)) {
        const Roadmap::Node& to = dut.node(edge.to);
        const Cost step = costOf(robot, Policy::kFastest, motionOf(dut, robot, node, edge));
        ASSERT_LE(here, step.us() + bound.us(to.pose.position(), to.mode));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OurMaps, GrownRoadmap,
                         ::testing::Values("scenario1", "scenario2a", "scenario3", "flat"));

TEST(Search, CostsWhatBellmanAndFordFind) {
  const Checker checker(test::ourWorld("scenario3"), test::nao());
  const Roadmap roadmap = grown(checker, 5, 2);
  const Robot& robot = *test::nao();
  EdgeChecks checks(roadmap, checker);
  Interrupt never(test::soon(), {});
  for (const Policy policy : {Policy::kPriority, Policy::kFastest}) {
    std::vector<Cost> least(roadmap.nodes.size(), Cost::most());
    least[0] = Cost();
    for (bool changed = true; changed;) {
      changed = false;
      for (Roadmap::NodeId node = 0; node < roadmap.nodes.size(); ++node) {
        if (least[node] == Cost::most()) continue;
        for (const Roadmap::Edge& edge : roadmap.edgesFrom(node)) {
          const Cost cost = least[node] + costOf(robot, policy, motionOf(roadmap, robot, node, edge));
          if (cost < least[edge.to]) least[edge.to] = cost, changed = true;
        }
      }
    }
    for (Roadmap::NodeId goal = 0; goal < roadmap.nodes.size(); goal += 37) {
      const auto dut =
          search(roadmap, robot, checks, {0, roadmap.node(goal).place, goal, policy, 0.0}, never);
      ASSERT_EQ(dut.has_value(), least[goal] != Cost::most());
      if (!dut) continue;
      Cost sum;
      for (const Motion& motion : *dut) sum = sum + costOf(robot, policy, motion);
      ASSERT_EQ(sum, least[goal]);
    }
  }
}

}  // namespace
}  // namespace underway
