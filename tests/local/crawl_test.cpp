#include "local/crawl.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

/// Scenario 3: down, under the table, and up.
class ThePassage : public ::testing::Test {
 protected:
  ThePassage() {
    Planner planner(world_, test::nao());
    plan_ = *planner.plan(test::requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}), test::soon());
    while (plan_.segments[down_].motion.to_mode != 2) ++down_;
    passage_ = passageFrom(plan_, *test::nao(), down_);
  }
  std::shared_ptr<const World> world_ = test::ourWorld("scenario3");
  Checker checker_{world_, test::nao()};
  Plan plan_;
  std::size_t down_ = 0;
  Passage passage_;
};

TEST_F(ThePassage, IsAsLongAsThePlanCrawlsAndAsWideAsItsTightestPlace) {
  EXPECT_NEAR(passage_.length_m, test::metresIn(plan_, 2), 1e-12);
  double least = 1.0;
  for (std::size_t i = down_; i < plan_.segments.size() && plan_.segments[i].motion.mode != 0; ++i)
    least = std::min(least, plan_.segments[i].closeness.clearance_m);
  EXPECT_LE(passage_.slack_m, least);
  EXPECT_LT(passage_.tolerance_m, passage_.slack_m);
}

TEST_F(ThePassage, IsEnteredTurnedAgainstHalfTheDrift) {
  const Pose planned = plan_.segments[down_].motion.from;
  EXPECT_EQ(entryOf(passage_, plan_, 0.0, checker_), planned);
  const double drift = 0.04;
  const Pose entry = entryOf(passage_, plan_, drift, checker_);
  // Along the arc that it will crawl it comes out on the line.
  double x = 0.0;
  double left = 0.0;
  for (double heading = entry.yaw - planned.yaw; x < passage_.length_m; x += 0.001) {
    left += 0.001 * heading;
    heading += 0.001 * drift;
  }
  EXPECT_NEAR(left, 0.0, 1e-4);
}

TEST_F(ThePassage, IsEnteredFurtherBackOrTurnedLessWhereTheTurnedBodyWouldReachTooFarAhead) {
  const Pose planned = plan_.segments[down_].motion.from;  // its way down ends .02 m before the table
  const Switch& down = *test::nao()->findSwitch(0, 2);
  for (const double drift : {-0.4, -0.1, -0.05, 0.05, 0.1, 0.4}) {
    SCOPED_TRACE(drift);
    const Pose entry = entryOf(passage_, plan_, drift, checker_);
    EXPECT_TRUE(checker_.isFree(switchModes(down, entry), 0.014));
    EXPECT_LE(std::abs(normalizedAngle(entry.yaw - planned.yaw)), 0.5 * std::abs(drift) * passage_.length_m);
    EXPECT_LE(distance(entry.position(), planned.position()), 0.031);
  }
}

TEST_F(ThePassage, LeavesNoRoomToGetUpUnderTheTableAndSomeBehindIt) {
  const Switch& up = *test::nao()->findSwitch(2, 0);
  EXPECT_FALSE(hasRoomUp(checker_, up, {4.0, 2.0, 0.0}, 0.0));
  EXPECT_TRUE(hasRoomUp(checker_, up, {4.7, 2.0, 0.0}, 0.0));
}

TEST_F(ThePassage, LeavesRoomOnlyWhereAllPlacesThatItMayBeAtHaveSome) {
  const Switch& up = *test::nao()->findSwitch(2, 0);
  EXPECT_TRUE(hasRoomUp(checker_, up, {4.65, 2.0, 0.0}, 0.01));
  EXPECT_FALSE(hasRoomUp(checker_, up, {4.65, 2.0, 0.0}, 0.10));
  EXPECT_TRUE(hasRoomUp(checker_, up, {4.80, 2.0, 0.0}, 0.10));
}

TEST_F(ThePassage, IsNearWhereTheTableIsCloserThanTheThresholdStraightAheadAndAWallIsNone) {
  constexpr double kTable_m = 3.7;
  const double front_m = test::nao()->modes[0].body_m.x.max;
  const auto is_near = [&](const Pose& at) { return isNearLow(checker_, 0, 2, at, 0.6); };
  EXPECT_TRUE(is_near({kTable_m - front_m - 0.59, 2.0, 0.0}));
  EXPECT_FALSE(is_near({kTable_m - front_m - 0.61, 2.0, 0.0}));
  EXPECT_FALSE(is_near({kTable_m - front_m - 0.59, 2.0, 3.1416}));
  EXPECT_FALSE(is_near({0.4, 2.0, 3.1416})) << "a wall, which no mode fits under";
}

TEST(Crawl, IsLessSureOfItsPlaceTheLongerItIs) {
  const CrawlSettings settings;
  EXPECT_GT(sigmaAfter(20.0, settings), sigmaAfter(5.0, settings));
  EXPECT_GT(sigmaAfter(0.0, settings), 0.0);
}

}  // namespace
}  // namespace underway
