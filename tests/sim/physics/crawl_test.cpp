// The crawl and the switches in physics, in a short form; `underway bench physics` has all seeds.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/switches.hpp"
#include "sim/physics/crawl_figures.hpp"
#include "sim/physics/journey.hpp"
#include "tests/sim/physics/nao_simulation.hpp"

namespace underway::physics {
namespace {

constexpr std::array<std::uint64_t, 2> kSeeds{0, 19};  // the smoothest floor and the roughest

TEST(CrawlInPhysics, TheNominalGaitAdvances60To85MillimetresACycleBelow207) {
  for (const std::uint64_t seed : kSeeds) {
    SCOPED_TRACE(seed);
    Simulation dut = nao(conditionsOf(seed));
    const CrawlFigures figures = measureCrawl(dut, gait::nominalGait(), 3);
    EXPECT_GE(figures.advance_m, 0.060);
    EXPECT_LE(figures.advance_m, 0.085);
    EXPECT_LE(figures.highest_m, 0.207);
    EXPECT_LT(std::abs(figures.aside_m), 0.005);
  }
}

TEST(CrawlInPhysics, StopsWhereItIsPaused) {
  Simulation dut = nao(conditionsOf(9));
  const gait::JointTable cycle = gait::crawlMotion(gait::naoCrawler(), gait::nominalGait()).value();
  dut.start(cycle, Posture::kLying, {});
  for (double pause_s = 0.4; pause_s < cycle.duration(); pause_s += 0.7) {
    SCOPED_TRACE(pause_s);
    gait::JointTable beginning(cycle.joints());
    for (std::size_t row = 0; row < cycle.rows() && cycle.time(row) < pause_s; ++row)
      beginning.append(cycle.time(row), cycle.angles(row));
    dut.start(cycle, Posture::kLying, {});
    dut.play(beginning, Posture::kLying);
    dut.hold(0.3, Posture::kLying);  // until the servos have arrived
    const Sample paused = dut.now();
    dut.hold(1.0, Posture::kLying);
    const Pose moved = relative(paused.lying, dut.now().lying);
    EXPECT_LT(std::hypot(moved.x, moved.y), 2e-3);
    EXPECT_NEAR(dut.now().hip_height_m, paused.hip_height_m, 2e-3);
  }
}

TEST(CrawlInPhysics, ATurnInThePushTurnsTheRobot) {
  gait::CrawlGait left = gait::cruiseGait();
  left.turn_rad = 0.08;
  gait::CrawlGait right = left;
  right.turn_rad = -0.08;
  Simulation dut = nao({});
  EXPECT_GT(measureCrawl(dut, left, 2).turn_rad, 0.02);
  EXPECT_LT(measureCrawl(dut, right, 2).turn_rad, -0.02);
}

TEST(CrawlInPhysics, ClimbsFiveDegrees) {
  Simulation dut = nao(conditionsOf(0), {.ground = {.uphill_rad = 0.0873}, .obstacles = {}});
  EXPECT_GT(measureCrawl(dut, gait::cruiseGait(), 2).advance_m, 0.06);
}

TEST(CrawlInPhysics, GoesDownCrawlsUnderATableAndStandsUpBehindIt) {
  const Table table{.depth_m = 0.2};  // short, to be quick
  const auto journey = crawlUnder(kRobot, table, gait::cruiseGait(), conditionsOf(19));
  ASSERT_TRUE(journey) << journey.error().message;
  EXPECT_TRUE(journey->stands);
  EXPECT_TRUE(journey->touches.empty()) << *journey->touches.begin();
  EXPECT_GT(journey->end.x, table.from_m + table.depth_m);
  EXPECT_LT(journey->crawl.most_heading_rad, 0.1);
}

}  // namespace
}  // namespace underway::physics
