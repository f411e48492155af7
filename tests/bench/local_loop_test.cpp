#include "bench/local_loop.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "bench/local_courses.hpp"
#include "tests/planner/fixture.hpp"

namespace underway::bench {
namespace {

/// A gap that leaves the mode's body 3 cm to either side: what noise leaves of walls in the robot's memory
/// must not close it, nor may the robot touch them.
class TightGap : public ::testing::TestWithParam<int> {};

TEST_P(TightGap, IsPassedWithAFewPlansAtMost) {
  const auto course = narrowCourse(*test::nao(), static_cast<ModeId>(GetParam()));
  ASSERT_TRUE(course) << course.error().message;
  Planner planner(course->map, test::nao());
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const LoopRun run = driveCourse(*course, planner, test::nao(), {}, {}, seed);
    EXPECT_TRUE(run.has_arrived) << "seed " << seed << ": " << run.why;
    EXPECT_FALSE(run.has_collided) << "seed " << seed;
    EXPECT_LE(run.plans, 3) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachMode, TightGap, ::testing::Values(0, 1, 2));

/// Boxes that are in no map, where robots have given up though there was a way.
struct Case {
  const char* map;
  unsigned long seed;
  friend std::ostream& operator<<(std::ostream& out, const Case& it) {
    return out << it.map << " with boxes of seed " << it.seed;
  }
};
using Unmapped = Course (*)(const Course&, const Plan&, const std::shared_ptr<const Robot>&, std::uint64_t);

void expectArrival(const Case& it, const std::shared_ptr<const Robot>& robot, Unmapped unmapped) {
  const std::string file = UNDERWAY_SOURCE_DIR "/maps/" + std::string(it.map) + ".yaml";
  const auto courses = coursesOf(file, *robot);
  ASSERT_TRUE(courses) << courses.error().message;
  const Course& course = (*courses)[it.seed % courses->size()];
  Planner planner(course.map, robot);
  planner.prepare(test::soon());
  const auto plan = planner.findPlan(course.request, test::soon());
  ASSERT_TRUE(plan) << plan.error().message;
  const Course with = unmapped(course, *plan, robot, it.seed);
  const LoopRun run = driveCourse(with, planner, robot, {}, {}, it.seed, {}, std::chrono::seconds(60));
  EXPECT_TRUE(run.has_arrived) << run.why;
  EXPECT_FALSE(run.has_collided) << run.why;
}

class UnmappedBoxes : public ::testing::TestWithParam<Case> {};

TEST_P(UnmappedBoxes, AreNoReasonToGiveUp) { expectArrival(GetParam(), test::nao(), withUnmappedBoxes); }

std::shared_ptr<const Robot> withDepth() {
  auto seeing = *test::nao();
  seeing.senses.depth = DepthSense{1.5, 3.0};
  return std::make_shared<const Robot>(seeing);
}

/// Beside the gap the plan keeps 2 cm, where 17 are: noise in what it remembers of the wall holds it there.
TEST(UnmappedTables, AreNoReasonToGiveUpInAGapThatHasRoom) {
  for (const unsigned long seed : {7UL, 17UL})
    expectArrival({"arena_gap", seed}, withDepth(), withUnmappedTables);
}

/// A camera's field leaves slivers of floor beside the way, close to where the robot stood first.
TEST(UnmappedTables, AreNoReasonToGiveUpInTheOpen) {
  expectArrival({"arena_open", 18}, withDepth(), withUnmappedTables);
}

INSTANTIATE_TEST_SUITE_P(WhereItComesNearerBitByBit, UnmappedBoxes,
                         ::testing::Values(Case{"arena_corridor", 10}, Case{"flat", 82}));
INSTANTIATE_TEST_SUITE_P(WhereAWholeStrokeLeavesNoRoomToGetUp, UnmappedBoxes,
                         ::testing::Values(Case{"flat", 63}));

}  // namespace
}  // namespace underway::bench
