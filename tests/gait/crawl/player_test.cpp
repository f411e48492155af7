#include "gait/crawl/player.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gait/crawl/switches.hpp"

namespace underway::gait {
namespace {

CrawlPlayer cruise() { return CrawlPlayer::make(naoCrawler(), cruiseGait()).value(); }

void expectFollows(const JointTable& before, const JointTable& next) {
  const auto end = before.angles(before.rows() - 1);
  const auto start = next.angles(0);
  for (std::size_t joint = 0; joint < end.size(); ++joint)
    EXPECT_NEAR(start[joint], end[joint], 1e-12) << next.joints()[joint];
}

/// Of the left side over the right one's: how much the two differ in the push.
double asymmetry(const JointTable& table) {
  const auto left = table.find("LHipPitch");
  const auto right = table.find("RHipPitch");
  double sum = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row)
    sum += table.angles(row)[*left] - table.angles(row)[*right];
  return sum;
}

TEST(CrawlPlayer, EveryMotionBeginsWhereTheLastOneEnded) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> heading(-0.1, 0.1);
  std::uniform_real_distribution<double> share(0.0, 1.2);
  CrawlPlayer dut = cruise();
  JointTable last = dut.down(0.0);
  for (int cycle = 0; cycle < 20; ++cycle) {
    const JointTable next = dut.cycle(heading(random), share(random));
    expectFollows(last, next);
    EXPECT_NEAR(next.duration(), dut.cycleTime(), 1e-9);
    last = next;
  }
  expectFollows(last, dut.up());
}

TEST(CrawlPlayer, GetsUpToHowItStoodBeforeItWentDown) {
  CrawlPlayer dut = cruise();
  const JointTable down = dut.down(0.3);
  const JointTable up = dut.up();
  const auto start = down.angles(0);
  const auto end = up.angles(up.rows() - 1);
  for (std::size_t joint = 0; joint < start.size(); ++joint) EXPECT_NEAR(end[joint], start[joint], 1e-12);
}

TEST(CrawlPlayer, TurnsBackToTheHeadingThatItWentDownAt) {
  for (const double line : {0.0, 1.0, 3.13, -3.13}) {
    SCOPED_TRACE(line);
    CrawlPlayer straight = cruise();
    (void)straight.down(line);
    EXPECT_NEAR(asymmetry(straight.cycle(line)), 0.0, 1e-9);
    CrawlPlayer left = cruise();
    CrawlPlayer right = cruise();
    (void)left.down(line);
    (void)right.down(line);
    const double leftward = asymmetry(left.cycle(line + 0.05));
    const double rightward = asymmetry(right.cycle(line - 0.05));
    EXPECT_GT(std::abs(leftward), 0.01);
    EXPECT_NEAR(leftward, -rightward, 1e-6);
  }
}

TEST(CrawlPlayer, LiesStillInTheRowItSays) {
  CrawlPlayer dut = cruise();
  const JointTable row = dut.lie(0.0);
  expectFollows(row, dut.cycle(0.0));
}

TEST(StrokeFor, BringsTheHipsThatShareOfTheWay) {
  const Crawler crawler = naoCrawler();
  const CrawlGait gait = cruiseGait();
  const LinkLengths lengths = crawler.lengths(gait.spread_m);
  const auto hip = [&](double phase) {
    return pointsOf(lengths, *pushPose(lengths, gait.push.at(phase), {gait.toe_to_elbow_m, 0.0}))[3].x;
  };
  for (double share = 0.05; share <= 1.0; share += 0.05)
    EXPECT_NEAR(hip(strokeFor(crawler, gait, share)) - hip(0.0), share * (hip(1.0) - hip(0.0)), 1e-6);
}

TEST(CrawlPlayer, RefusesAGaitThatLeavesNoRoomToSteer) {
  const auto player = CrawlPlayer::make(naoCrawler(), cruiseGait(), {.most_turn_rad = 1.0});
  ASSERT_FALSE(player);
  EXPECT_FALSE(player.error().message.empty());
}

}  // namespace
}  // namespace underway::gait
