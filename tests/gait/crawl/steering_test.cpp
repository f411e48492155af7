#include "gait/crawl/steering.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/gait.hpp"

namespace underway::gait {
namespace {

TEST(TurnTowards, OnTheLineAndAlongItIsStraightAhead) { EXPECT_EQ(turnTowards({}), 0.0); }

TEST(TurnTowards, TurnsAgainstTheErrorAndNoMoreThanTheJointsLeaveRoomFor) {
  const Steering steering;
  EXPECT_LT(turnTowards({.heading_rad = 0.01, .left_m = 0.0}), 0.0);  // heading left: turn right
  EXPECT_LT(turnTowards({.heading_rad = 0.0, .left_m = 0.01}), 0.0);  // left of the line: turn right
  EXPECT_EQ(turnTowards({.heading_rad = -1.0, .left_m = 0.0}), steering.most_turn_rad);
  EXPECT_EQ(turnTowards({.heading_rad = 1.0, .left_m = 0.0}), -steering.most_turn_rad);
}

TEST(TurnTowards, LeftAndRightAreAlike) {
  for (const double heading : {0.0, 0.01, 0.05})
    for (const double left : {0.0, 0.004, 0.2})
      EXPECT_EQ(turnTowards({heading, left}), -turnTowards({-heading, -left}));
}

TEST(Reckon, AddsUpWhatTheHeadingSays) {
  const Steering steering;
  const OffLine straight = reckon({.heading_rad = 0.1, .left_m = 0.02}, 0.1, 0.0);
  EXPECT_DOUBLE_EQ(straight.left_m, 0.02 + steering.advance_m * std::sin(0.1));
  const OffLine turned = reckon({}, 0.0, 0.05);
  EXPECT_DOUBLE_EQ(turned.left_m, 0.05 * steering.aside_m_per_rad);
}

TEST(Steering, ALineIsFoundAgainByARobotThatDoesWhatItReckons) {
  constexpr double kShare = 0.5;  // of the turn asked for comes about
  OffLine off{.heading_rad = 0.05, .left_m = 0.03};
  for (int cycle = 0; cycle < 40; ++cycle) {
    const double turn = turnTowards(off);
    off = reckon(off, off.heading_rad + kShare * turn, turn);
  }
  EXPECT_NEAR(off.heading_rad, 0.0, 2e-3);
  EXPECT_NEAR(off.left_m, 0.0, 2e-3);
}

TEST(Steering, TheCruiseLeavesRoomForTheGreatestTurn) {
  for (const double sign : {-1.0, 1.0}) {
    CrawlGait gait = cruiseGait();
    gait.turn_rad = sign * Steering{}.most_turn_rad;
    const auto motion = crawlMotion(naoCrawler(), gait);
    EXPECT_TRUE(motion) << motion.error().message;
  }
}

}  // namespace
}  // namespace underway::gait
