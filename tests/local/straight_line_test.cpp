#include "local/godzila/straight_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace underway {
namespace {

Scan emptyScan() {
  Scan scan;
  scan.ranges_m.assign(scan.beams.count, Scan::kNothing);
  return scan;
}

/// A wall across the way with a gap in its middle.
Scan gapAhead(double range_m, double gap_m) {
  Scan scan = emptyScan();
  for (std::size_t i = 0; i < scan.beams.count; ++i) {
    const double bearing = scan.beams.bearing(i);
    if (std::cos(bearing) > 0.1 && std::abs(range_m * std::tan(bearing)) > 0.5 * gap_m)
      scan.ranges_m[i] = static_cast<float>(range_m / std::cos(bearing));
  }
  return scan;
}

TEST(StraightLine, IsThereThroughAGapThatIsWideEnough) {
  EXPECT_TRUE(isLaneFree(gapAhead(1.0, 0.73), {3.0, 0.0}, 0.27));
  EXPECT_FALSE(isLaneFree(gapAhead(1.0, 0.50), {3.0, 0.0}, 0.27));
}

TEST(StraightLine, IsFreeUpToAGoalBeforeTheWall) {
  EXPECT_TRUE(isLaneFree(gapAhead(1.0, 0.0), {0.8, 0.0}, 0.27));
  EXPECT_FALSE(isLaneFree(gapAhead(1.0, 0.0), {1.2, 0.0}, 0.27));
}

TEST(StraightLine, IsNotThereWhereNothingIsSeen) { EXPECT_FALSE(isLaneFree(emptyScan(), {1.0, 3.0}, 0.27)); }

TEST(StraightLine, LeadsItsGoalFromTheRobotToTheGoalAsTimePasses) {
  StraightLine dut({0.27, 0.05, 0.3});
  double last = 0.0;
  for (double now = 0.0; now < 60.0; now += 1.0) {  // T_f is 3 m / 0.05 m/s
    const auto goal = dut.intermediate(emptyScan(), {3.0, 0.4}, now);
    ASSERT_TRUE(goal.has_value());
    EXPECT_EQ(goal->bearing_rad, 0.4);
    EXPECT_GE(goal->range_m, std::max(last, 0.3));
    EXPECT_LE(goal->range_m, 3.0);
    last = goal->range_m;
  }
  EXPECT_GT(last, 2.9);
}

TEST(StraightLine, BeginsAnewAfterItsTime) {
  StraightLine dut({0.27, 0.05, 0.3});
  ASSERT_TRUE(dut.intermediate(emptyScan(), {3.0, 0.0}, 0.0));
  EXPECT_GT(dut.intermediate(emptyScan(), {3.0, 0.0}, 59.0)->range_m, 2.9);
  EXPECT_DOUBLE_EQ(dut.intermediate(emptyScan(), {3.0, 0.0}, 61.0)->range_m, 0.3);
}

TEST(StraightLine, StopsWhenSomethingComesIntoIt) {
  StraightLine dut({0.27, 0.05, 0.3});
  ASSERT_TRUE(dut.intermediate(emptyScan(), {3.0, 0.0}, 0.0));
  EXPECT_FALSE(dut.intermediate(gapAhead(1.0, 0.0), {3.0, 0.0}, 1.0));
}

}  // namespace
}  // namespace underway
