#include "bench/local_loop.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace underway::bench
