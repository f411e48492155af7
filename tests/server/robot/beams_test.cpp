#include "server/robot/beams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

/// Lidars of all kinds, told as the one that the local layer is made for.
namespace underway {
namespace {

constexpr double kPi = std::numbers::pi;

/// What a lidar at a pose sees of a wall that stands at x = 2 m ahead of the body.
std::vector<float> wallSeenBy(const Beams& beams, const Pose& lidar) {
  std::vector<float> ranges;
  for (std::size_t i = 0; i < beams.count; ++i) {
    const double towards = beams.bearing(i) + lidar.yaw;
    const double away = (2.0 - lidar.x) / std::cos(towards);
    ranges.push_back(std::cos(towards) > 0.05 ? static_cast<float>(away) : Scan::kNothing);
  }
  return ranges;
}

TEST(Beams, OfTheRightKindArriveAsTheyAre) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> range(0.02F, 5.6F);
  std::vector<float> ranges(Beams{}.count);
  for (float& r : ranges) r = range(random);
  ranges[7] = Scan::kNothing;
  EXPECT_EQ(asStandardScan(Beams{}, ranges, 3.0).ranges_m, ranges);
}

TEST(Beams, OfAnyLidarAnywhereShowTheSameWall) {
  const std::pair<Beams, Pose> cases[] = {
      {{360, -kPi, kPi / 180.0}, {}},                        // all round, one degree
      {{1081, -0.75 * kPi, 1.5 * kPi / 1080.0}, {}},         // finer than ours
      {{360, -kPi, kPi / 180.0}, {0.1, -0.05, 0.0}},         // ahead of the body and to its right
      {{720, 0.0, kPi / 360.0}, {0.0, 0.0, kPi}},            // mounted backwards
      {{720, kPi, -kPi / 360.0}, {-0.08, 0.0, 0.4}},         // upside down
      {{61, -kPi / 3.0, 2.0 * kPi / 180.0}, {0.0, 0.1, 0}},  // coarse and narrow
  };
  for (const auto& [beams, lidar] : cases) {
    const Scan scan = asStandardScan(beams, wallSeenBy(beams, lidar), 0.0, {lidar, 0.0});
    ASSERT_EQ(scan.ranges_m.size(), Beams{}.count);
    for (std::size_t i = 0; i < scan.beams.count; ++i) {
      const double bearing = scan.beams.bearing(i);
      if (std::abs(bearing) > 0.8) continue;
      const double wall = 2.0 / std::cos(bearing);
      EXPECT_NEAR(scan.ranges_m[i], wall, 0.06 * wall) << beams.count << " beams, at " << bearing;
    }
  }
}

TEST(Beams, TellNothingWhereNothingWasMeasuredOrLookedAt) {
  const Beams ahead{91, -kPi / 4.0, kPi / 180.0};
  std::vector<float> ranges(ahead.count, 1.0F);
  ranges[45] = std::nanf("");
  ranges[44] = 0.0F;                // what some drivers tell for an error
  ranges[46] = -Scan::kNothing;     // and others
  ranges[43] = ranges[47] = 0.01F;  // too near to be measured
  const Scan scan = asStandardScan(ahead, ranges, 0.0, {{}, 0.02});
  for (std::size_t i = 0; i < scan.beams.count; ++i) {
    const double degrees = std::abs(scan.beams.bearing(i)) * 180.0 / kPi;
    if (degrees < 2.4 || degrees > 45.6) {
      EXPECT_EQ(scan.ranges_m[i], Scan::kNotLooked) << degrees;
    }
    if (degrees > 2.6 && degrees < 44.9) {
      EXPECT_FLOAT_EQ(scan.ranges_m[i], 1.0F) << degrees;
    }
  }
}

TEST(Beams, ThatMeetNothingTellThatNothingIsThere) {
  const Beams ahead{91, -kPi / 4.0, kPi / 180.0};
  const Scan scan = asStandardScan(ahead, std::vector<float>(ahead.count, Scan::kNothing), 0.0);
  for (std::size_t i = 0; i < scan.beams.count; ++i) {
    const double degrees = std::abs(scan.beams.bearing(i)) * 180.0 / kPi;
    if (degrees < 44.9) {
      EXPECT_EQ(scan.ranges_m[i], Scan::kNothing) << degrees;
    }
    if (degrees > 45.6) {
      EXPECT_EQ(scan.ranges_m[i], Scan::kNotLooked) << degrees;
    }
  }
}

TEST(Beams, TheNearestOfManyIsKept) {
  const Beams fine{6830, -2.0 * kPi / 3.0, 4.0 * kPi / 3.0 / 6829.0};
  std::vector<float> ranges(fine.count, 4.0F);
  ranges[3415] = 0.7F;
  const Scan scan = asStandardScan(fine, ranges, 0.0);
  EXPECT_FLOAT_EQ(scan.ranges_m[341], 0.7F);
  EXPECT_FLOAT_EQ(scan.ranges_m[300], 4.0F);
}

TEST(Beams, OutOfRangeAreRefusedByField) {
  EXPECT_EQ(faultOf(Beams{}), "");
  EXPECT_EQ(faultOf({360, 0.0, -kPi / 180.0}), "");
  EXPECT_NE(faultOf({10, std::nan(""), 0.1}).find("first_rad"), std::string::npos);
  EXPECT_NE(faultOf({10, 0.0, 0.0}).find("step_rad"), std::string::npos);
  EXPECT_NE(faultOf({10, 0.0, std::nan("")}).find("step_rad"), std::string::npos);
  EXPECT_NE(faultOf({1000, 0.0, 0.1}).find("step_rad"), std::string::npos);
}

}  // namespace
}  // namespace underway
