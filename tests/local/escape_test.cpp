#include "local/godzila/escape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace underway {
namespace {

Scan openScan(float range_m) {
  Scan scan;
  scan.ranges_m.assign(scan.beams.count, range_m);
  return scan;
}

/// How many random goals an escape from the n-th trap takes, each kept for its whole time.
int goalsAfterTraps(int traps, const EscapeSettings& settings) {
  const Scan scan = openScan(4.0F);
  Escape dut(settings, 1);
  double now = 0.0;
  int goals = 0;
  for (int k = 0; k < traps; ++k) {
    dut.begin(scan, {}, now);
    goals = 0;
    for (Point last{1e9, 0.0}; const auto goal = dut.goal(scan, {}, now); now += 0.1)
      if (!(*goal == last)) last = *goal, ++goals;
  }
  return goals;
}

TEST(Escape, TakesAsManyRandomGoalsAsThereWereTraps) {
  const EscapeSettings settings;
  for (int traps = 1; traps <= 4; ++traps) EXPECT_EQ(goalsAfterTraps(traps, settings), traps);
}

TEST(Escape, TakesNoMoreThanItsMost) {
  EscapeSettings settings;
  settings.most_repeats = 2;
  EXPECT_EQ(goalsAfterTraps(5, settings), 2);
}

TEST(Escape, PicksGoalsThatTheScanSaysAreFree) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Scan scan = openScan(0.6F);
    for (std::size_t i = 0; i < 200; ++i) scan.ranges_m[i] = 3.0F;
    Escape dut({}, seed);
    dut.begin(scan, {}, 0.0);
    const auto goal = dut.goal(scan, {}, 0.0);
    ASSERT_TRUE(goal.has_value());
    const double range = distance(*goal, {0.0, 0.0});
    EXPECT_LE(range, 3.0) << "seed " << seed;
    if (std::atan2(goal->y, goal->x) > -0.5 && range > 0.31) {
      EXPECT_LT(range, 0.6) << "seed " << seed;
    }
  }
}

TEST(Escape, IsTheSameForTheSameSeed) {
  const Scan scan = openScan(4.0F);
  Escape a({}, 7);
  Escape b({}, 7);
  a.begin(scan, {}, 0.0);
  b.begin(scan, {}, 0.0);
  EXPECT_EQ(*a.goal(scan, {}, 0.0), *b.goal(scan, {}, 0.0));
}

TEST(Escape, EndsAGoalThatIsReached) {
  const Scan scan = openScan(4.0F);
  Escape dut({}, 1);
  dut.begin(scan, {}, 0.0);
  const Point goal = *dut.goal(scan, {}, 0.0);
  EXPECT_FALSE(dut.goal(scan, {goal.x, goal.y, 0.0}, 1.0).has_value());
  EXPECT_FALSE(dut.isGoingOn());
}

}  // namespace
}  // namespace underway
