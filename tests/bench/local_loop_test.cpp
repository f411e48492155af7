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
class UnmappedBoxes : public ::testing::TestWithParam<Case> {};

TEST_P(UnmappedBoxes, AreNoReasonToGiveUp) {
  const std::string file = UNDERWAY_SOURCE_DIR "/maps/" + std::string(GetParam().map) + ".yaml";
  const auto courses = coursesOf(file, *test::nao());
  ASSERT_TRUE(courses) << courses.error().message;
  const Course& course = (*courses)[GetParam().seed % courses->size()];
  Planner planner(course.map, test::nao());
  planner.prepare(test::soon());
  const auto plan = planner.findPlan(course.request, test::soon());
  ASSERT_TRUE(plan) << plan.error().message;
  const Course with = withUnmappedBoxes(course, *plan, test::nao(), GetParam().seed);
  const LoopRun run =
      driveCourse(with, planner, test::nao(), {}, {}, GetParam().seed, {}, std::chrono::seconds(60));
  EXPECT_TRUE(run.has_arrived) << run.why;
  EXPECT_FALSE(run.has_collided) << run.why;
}

INSTANTIATE_TEST_SUITE_P(WhereItComesNearerBitByBit, UnmappedBoxes,
                         ::testing::Values(Case{"arena_corridor", 10}, Case{"flat", 82}));
INSTANTIATE_TEST_SUITE_P(WhereAWholeStrokeLeavesNoRoomToGetUp, UnmappedBoxes,
                         ::testing::Values(Case{"flat", 63}));

}  // namespace
}  // namespace underway::bench
