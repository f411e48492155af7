#include "local/gait_runner.hpp"

#include <gtest/gtest.h>

#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

constexpr ModeId kFrontal = 0;
constexpr ModeId kLateral = 1;
constexpr ModeId kCrawl = 2;
constexpr double kTick_s = 0.1;

using test::nao;

GaitRunner runnerIn(ModeId mode) {
  return {nao(), gait::CrawlPlayer::make(gait::naoCrawler(), gait::cruiseGait()).value(), mode};
}

Command crawlOn(double share = 1.0) { return {{0.025 * share, 0.0, 0.0}, {}}; }

/// Ticks until nothing moves any more, the same command in the first tick only.
int ticksOf(GaitRunner& dut, const Command& command) {
  int ticks = 0;
  for (Command now = command; dut.tick(now, 0.0, kTick_s); now = {}) ++ticks;
  return ticks;
}

TEST(GaitRunner, LeavesWalkingToTheRobot) {
  GaitRunner dut = runnerIn(kFrontal);
  EXPECT_FALSE(dut.tick({{0.05, 0.0, 0.1}, {}}, 0.0, kTick_s));
  EXPECT_TRUE(dut.isWalking());
  EXPECT_FALSE(dut.tick({{}, kLateral}, 0.0, kTick_s));
  EXPECT_EQ(dut.mode(), kLateral);
}

TEST(GaitRunner, TakesAsLongToLieDownAsTheRobotFileSays) {
  GaitRunner dut = runnerIn(kFrontal);
  const int ticks = ticksOf(dut, {{}, kCrawl});
  EXPECT_EQ(dut.mode(), kCrawl);
  EXPECT_NEAR(ticks * kTick_s, nao()->findSwitch(kFrontal, kCrawl)->duration_s, 0.11);
  EXPECT_NEAR(ticksOf(dut, {{}, kFrontal}) * kTick_s, nao()->findSwitch(kCrawl, kFrontal)->duration_s, 0.21);
  EXPECT_EQ(dut.mode(), kFrontal);
}

TEST(GaitRunner, FinishesAMotionWhateverIsCommandedMeanwhile) {
  GaitRunner dut = runnerIn(kCrawl);
  ASSERT_TRUE(dut.tick(crawlOn(), 0.0, kTick_s));
  EXPECT_TRUE(dut.tick({{}, kFrontal}, 0.0, kTick_s));
  EXPECT_FALSE(dut.isSwitching());
  EXPECT_EQ(dut.cycles(), 0U);
  while (dut.tick({}, 0.0, kTick_s)) {
  }
  EXPECT_EQ(dut.cycles(), 1U);
  EXPECT_EQ(dut.mode(), kCrawl);
}

TEST(GaitRunner, PlaysMotionsWithoutAJumpFromTickToTick) {
  GaitRunner dut = runnerIn(kFrontal);
  std::optional<gait::JointTable> last;
  const auto expectSmooth = [&](const Command& command) {
    for (Command now = command; auto part = dut.tick(now, 0.0, kTick_s); now = {}) {
      for (std::size_t joint = 0; last && joint < part->joints().size(); ++joint)
        ASSERT_NEAR(part->angles(0)[joint], last->angles(last->rows() - 1)[joint], 1e-9);
      last = std::move(part);
    }
  };
  expectSmooth({{}, kCrawl});
  expectSmooth(crawlOn());
  expectSmooth(crawlOn(0.4));
  expectSmooth({{}, kFrontal});
  EXPECT_EQ(dut.cycles(), 2U);
  EXPECT_EQ(dut.mode(), kFrontal);
}

TEST(GaitRunner, DoesNothingWithoutACommandOrForASwitchThatIsNotListed) {
  GaitRunner dut = runnerIn(kCrawl);
  EXPECT_FALSE(dut.tick({}, 0.0, kTick_s));
  EXPECT_FALSE(dut.tick({{}, kLateral}, 0.0, kTick_s));
  EXPECT_EQ(dut.mode(), kCrawl);
}

}  // namespace
}  // namespace underway
