#include "gait/joint_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace underway::gait {
namespace {

JointTable twoRows() {
  JointTable table({"LKneePitch", "RKneePitch"});
  table.append(1.0, std::array{0.0, 1.0});
  table.append(3.0, std::array{1.0, -1.0});
  return table;
}

TEST(JointTable, RunsStraightBetweenRowsAndStaysOutsideThem) {
  const JointTable dut = twoRows();
  EXPECT_DOUBLE_EQ(dut.duration(), 2.0);
  EXPECT_EQ(dut.sample(0.0), (std::vector{0.0, 1.0}));
  EXPECT_EQ(dut.sample(1.0), (std::vector{0.0, 1.0}));
  EXPECT_EQ(dut.sample(1.5), (std::vector{0.25, 0.5}));
  EXPECT_EQ(dut.sample(3.0), (std::vector{1.0, -1.0}));
  EXPECT_EQ(dut.sample(9.0), (std::vector{1.0, -1.0}));
}

TEST(JointTable, FindsJointsByName) {
  const JointTable dut = twoRows();
  EXPECT_EQ(dut.find("RKneePitch"), 1U);
  EXPECT_FALSE(dut.find("rkneepitch"));
}

TEST(JointTable, FollowsAnotherWithoutTheRowTheyShare) {
  JointTable dut = twoRows();
  JointTable next(dut.joints());
  next.append(10.0, std::array{1.0, -1.0});
  next.append(10.5, std::array{2.0, 2.0});
  dut.append(next);
  ASSERT_EQ(dut.rows(), 3U);
  EXPECT_DOUBLE_EQ(dut.time(2), 3.5);
  EXPECT_EQ(dut.sample(3.5), (std::vector{2.0, 2.0}));
}

TEST(JointTable, FollowsItselfWhenItEndsWhereItBegins) {
  JointTable dut({"HeadYaw"});
  for (const double time_s : {0.0, 1.0, 2.0}) dut.append(time_s, std::array{std::abs(time_s - 1.0)});
  dut.append(dut);
  EXPECT_EQ(dut.rows(), 5U);
  EXPECT_EQ(dut.sample(3.0), std::vector{0.0});
}

TEST(JointTable, IsTheSameMotionWithDenserRows) {
  const JointTable dut = twoRows().denser(0.3);
  EXPECT_EQ(dut.rows(), 8U);
  EXPECT_EQ(dut.angles(7)[0], 1.0);
  for (double time_s = 0.5; time_s < 3.5; time_s += 0.1)
    EXPECT_NEAR(dut.sample(time_s)[1], twoRows().sample(time_s)[1], 1e-12);
  EXPECT_EQ(twoRows().denser(5.0), twoRows());
}

TEST(JointTable, PartsOfItPlayedInTurnAreTheWholeMotion) {
  const JointTable whole = twoRows();
  JointTable dut = whole.part(whole.time(0), 1.3);
  for (double from = 1.3; from < 3.4; from += 0.7) dut.append(whole.part(from, from + 0.7));
  for (double time_s = 0.5; time_s < 4.0; time_s += 0.1)
    EXPECT_NEAR(dut.sample(time_s)[1], whole.sample(time_s)[1], 1e-12);
}

TEST(JointTable, RefusesToJumpToWhatFollows) {
  JointTable dut = twoRows();
  JointTable elsewhere(dut.joints());
  elsewhere.append(0.0, std::array{0.5, -1.0});
  EXPECT_THROW(dut.append(elsewhere), std::invalid_argument);
  EXPECT_THROW(dut.append(JointTable({"HeadYaw"})), std::invalid_argument);
}

TEST(JointTable, RefusesRowsThatNoReaderCouldPlay) {
  JointTable dut = twoRows();
  EXPECT_THROW(dut.append(3.0, std::array{0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(dut.append(4.0, std::array{0.0}), std::invalid_argument);
  EXPECT_THROW(dut.append(4.0, std::array{0.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(dut.append(std::numeric_limits<double>::infinity(), std::array{0.0, 0.0}),
               std::invalid_argument);
  EXPECT_THROW(JointTable({"HeadYaw", "HeadYaw"}), std::invalid_argument);
  EXPECT_THROW(JointTable({""}), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(JointTable({"HeadYaw"}).sample(0.0)), std::logic_error);
  EXPECT_EQ(dut, twoRows()) << "a refused row left something behind";
}

}  // namespace
}  // namespace underway::gait
