#include "local/executor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sim/robot.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

/// Scenario 3 executed with honest noise: round a wall and under a table.
class Executing3 : public ::testing::Test {
 protected:
  Executing3() {
    Planner planner(world_, test::nao());
    plan_ = *planner.plan(test::requestFor(kStart, kGoal), test::soon());
    dut_.follow(plan_, world_, *world_);
  }

  /// Until a state is reached, or so many ticks have passed; calls back before each step.
  State runUntil(State state, int ticks, const std::function<void(const Tick&)>& each = {}) {
    State now = dut_.state();
    for (int k = 0; k < ticks && now != state; ++k) {
      const Tick tick = dut_.tick(body_.sense());
      now = tick.state;
      if (each) each(tick);
      body_.step(tick.command);
    }
    return now;
  }

  static constexpr Pose kStart{0.6, 2.0, 0.0};
  static constexpr Pose kGoal{5.4, 2.0, 0.0};
  std::shared_ptr<const World> world_ = test::ourWorld("scenario3");
  sim::SimulatedRobot body_{world_, test::nao(), kStart, 0, 11};
  Plan plan_;
  Executor dut_{test::nao()};
};

TEST_F(Executing3, ArrivesWithin5CmAnd5DegreesAndTouchesNothing) {
  EXPECT_EQ(runUntil(State::kArrived, 5000), State::kArrived);
  EXPECT_FALSE(body_.truth().has_collided) << body_.truth().with;
  EXPECT_FALSE(body_.truth().is_disputed);
  EXPECT_LT(distance(body_.truth().pose.position(), kGoal.position()), 0.05);
  EXPECT_LT(std::abs(normalizedAngle(body_.truth().pose.yaw - kGoal.yaw)), 0.087);
}

TEST_F(Executing3, GoesDownOnceAndUpOnce) {
  int switches = 0;
  State last = State::kIdle;
  runUntil(State::kArrived, 5000, [&](const Tick& tick) {
    if (tick.state != last && (tick.state == State::kGoingDown || tick.state == State::kGettingUp))
      ++switches;
    last = tick.state;
  });
  EXPECT_EQ(switches, 2);
}

TEST_F(Executing3, ByThePapersTriggerGoesDownAtItsThresholdAndGetsUpAfterItsCycles) {
  constexpr Pose kStraightBefore{2.3, 2.0, 0.0};
  Planner planner(world_, test::nao());
  const Plan plan = *planner.plan(test::requestFor(kStraightBefore, kGoal), test::soon());
  for (const PapersTrigger& papers : {PapersTrigger{0.7, 24}, PapersTrigger{1.0, 31}}) {
    ExecutorSettings settings;
    settings.crawl.papers = papers;
    dut_ = Executor(test::nao(), settings);
    body_ = sim::SimulatedRobot(world_, test::nao(), kStraightBefore, 0, 11);
    dut_.follow(plan, world_, *world_);
    EXPECT_EQ(runUntil(State::kAligning, 5000), State::kAligning);
    const double front_m = body_.truth().pose.x + test::nao()->modes[0].body_m.x.max;
    EXPECT_NEAR(3.7 - front_m, papers.threshold_m, 0.05);
    EXPECT_EQ(runUntil(State::kGoingDown, 3), State::kGoingDown) << "as it stands";
    EXPECT_EQ(runUntil(State::kGettingUp, 5000), State::kGettingUp);
    EXPECT_EQ(body_.sense().cycles, static_cast<std::uint64_t>(papers.cycles));
    EXPECT_FALSE(body_.truth().has_collided) << body_.truth().with;
  }
}

TEST_F(Executing3, NeverGetsUpUnderTheTable) {
  runUntil(State::kGettingUp, 5000);
  const Switch& up = *test::nao()->findSwitch(2, 0);
  EXPECT_TRUE(Checker(world_, test::nao()).isFree(switchModes(up, body_.truth().pose), 0.0));
}

TEST_F(Executing3, SendsNoVelocityThatANaoCannotWalk) {
  const SpeedLimits limits = standingLimits(*test::nao());
  runUntil(State::kGoingDown, 5000, [&](const Tick& tick) {
    EXPECT_LE(std::abs(tick.command.velocity.x_mps), limits.forward_mps + 1e-12);
    EXPECT_LE(std::abs(tick.command.velocity.y_mps), limits.left_mps + 1e-12);
    EXPECT_LE(std::abs(tick.command.velocity.turn_radps), limits.turn_radps + 1e-12);
  });
}

TEST_F(Executing3, StandsStillWhileItIsLostAndGoesOnAfterwards) {
  runUntil(State::kWalking, 100);
  body_.loseItself(true);
  EXPECT_EQ(runUntil(State::kLost, 30), State::kLost);
  const Pose there = body_.truth().pose;
  for (int k = 0; k < 50; ++k) body_.step(dut_.tick(body_.sense()).command);
  EXPECT_EQ(body_.truth().pose, there);
  body_.loseItself(false);
  EXPECT_EQ(runUntil(State::kArrived, 5000), State::kArrived);
  EXPECT_FALSE(body_.truth().has_collided);
  EXPECT_FALSE(body_.truth().is_disputed);
}

TEST_F(Executing3, SendsNothingAfterAFall) {
  runUntil(State::kWalking, 100);
  body_.fall();
  EXPECT_EQ(runUntil(State::kFallen, 3), State::kFallen);
  EXPECT_EQ(dut_.tick(body_.sense()).command, Command{});
}

TEST_F(Executing3, TellsACrawlThatDoesNotProgress) {
  runUntil(State::kCrawling, 5000);
  body_.stall(true);
  EXPECT_EQ(runUntil(State::kStalled, 400), State::kStalled);
  EXPECT_EQ(dut_.tick(body_.sense()).command, Command{});
}

TEST_F(Executing3, CountsCyclesByTheirProgressAndNotByTime) {
  runUntil(State::kCrawling, 5000);
  body_.stall(true);  // for less than it waits
  for (int k = 0; k < 60; ++k) body_.step(dut_.tick(body_.sense()).command);
  body_.stall(false);
  EXPECT_EQ(runUntil(State::kArrived, 5000), State::kArrived);
  EXPECT_FALSE(body_.truth().has_collided);
  EXPECT_FALSE(body_.truth().is_disputed);
}

TEST_F(Executing3, BelievesNothingOfStrokesThatWereCrawledBefore) {
  for (int k = 0; k < 30; ++k) {
    Senses senses = body_.sense();
    senses.cycles += 31;
    body_.step(dut_.tick(senses).command);
    ASSERT_LT(distance(dut_.pose().position(), body_.truth().pose.position()), 0.05) << "tick " << k;
  }
}

TEST_F(Executing3, BelievesNothingOfACountThatBeginsAnew) {
  runUntil(State::kCrawling, 5000);
  for (int k = 0; k < 60; ++k) body_.step(dut_.tick(body_.sense()).command);
  const Point before = dut_.pose().position();
  Senses senses = body_.sense();
  senses.cycles = 0;
  (void)dut_.tick(senses);
  EXPECT_LT(distance(dut_.pose().position(), before), 0.1);
}

TEST_F(Executing3, WantsAnotherPlanWhereItWasCarriedElsewhere) {
  runUntil(State::kWalking, 100);
  body_.loseItself(true);
  EXPECT_EQ(runUntil(State::kLost, 30), State::kLost);
  const Pose elsewhere{1.2, 1.0, 0.5};
  sim::SimulatedRobot carried(world_, test::nao(), elsewhere, 0, 12);
  State state = State::kLost;
  for (int k = 0; k < 100 && state != State::kBlocked; ++k) {
    const Tick tick = dut_.tick(carried.sense());
    state = tick.state;
    carried.step(tick.command);
  }
  EXPECT_EQ(state, State::kBlocked);
  EXPECT_FALSE(dut_.isHeld());
  EXPECT_LT(distance(carried.truth().pose.position(), elsewhere.position()), 0.05);
  EXPECT_LT(distance(dut_.pose().position(), elsewhere.position()), 0.03);
}

TEST_F(Executing3, GoesByLocalisationThatMissesEverySecondFix) {
  State state = State::kIdle;
  for (int k = 0; k < 5000 && state != State::kArrived; ++k) {
    Senses senses = body_.sense();
    if (k % 2 == 1) senses.pose.reset();
    const Tick tick = dut_.tick(senses);
    state = tick.state;
    body_.step(tick.command);
  }
  EXPECT_EQ(state, State::kArrived);
  EXPECT_FALSE(body_.truth().has_collided);
}

TEST_F(Executing3, TellsAChangeOfModeThatDoesNotCome) {
  EXPECT_EQ(runUntil(State::kGoingDown, 5000), State::kGoingDown);
  State state = State::kGoingDown;
  for (int k = 0; k < 900 && state == State::kGoingDown; ++k) {
    Senses senses = body_.sense();
    senses.mode = 0;
    senses.is_switching = false;
    state = dut_.tick(senses).state;
  }
  EXPECT_EQ(state, State::kStalled);
  EXPECT_NE(dut_.whyStalled().find("does not change"), std::string_view::npos);
}

TEST_F(Executing3, CrawlsOnByANewPlanAfterAStall) {
  runUntil(State::kCrawling, 5000);
  for (int k = 0; k < 200; ++k) body_.step(dut_.tick(body_.sense()).command);  // to under the table
  body_.stall(true);
  EXPECT_EQ(runUntil(State::kStalled, 400), State::kStalled);
  body_.stall(false);
  Request request = test::requestFor(dut_.pose(), kGoal);
  request.start_mode = dut_.mode();
  const auto plan = Planner(world_, test::nao()).plan(request, test::soon());
  ASSERT_TRUE(plan);
  dut_.follow(*plan, world_, *world_);
  EXPECT_EQ(runUntil(State::kArrived, 5000), State::kArrived) << dut_.whyStalled();
  EXPECT_FALSE(body_.truth().has_collided);
}

/// What it sees while it lies does not lead its belief along: that is told of a stroke when it has ended.
TEST(ExecutingWithHead, KnowsHowFarItHasCrawled) {
  auto seeing = *test::nao();
  seeing.senses.head = LidarSense{0.15};
  const auto robot = std::make_shared<const Robot>(seeing);
  const auto world = test::ourWorld("scenario3");
  const Pose start{0.6, 2.0, 0.0};
  const auto plan = Planner(world, robot).plan(test::requestFor(start, {5.4, 2.0, 0.0}), test::soon());
  ASSERT_TRUE(plan);
  sim::SimulatedRobot body(world, robot, start, 0, 11);
  Executor dut(robot);
  dut.follow(*plan, world, *world);
  for (int k = 0; k < 5000 && dut.state() != State::kGettingUp; ++k)
    body.step(dut.tick(body.sense()).command);
  ASSERT_EQ(dut.state(), State::kGettingUp);
  EXPECT_LT(distance(dut.pose().position(), body.truth().pose.position()), 0.06);
}

TEST_F(Executing3, StandsStillWithoutAPlan) {
  runUntil(State::kWalking, 100);
  dut_.stop();
  const Tick tick = dut_.tick(body_.sense());
  EXPECT_EQ(tick.state, State::kIdle);
  EXPECT_EQ(tick.command, Command{});
}

/// Walks backwards along a lane that an unmapped table top reaches into from one side, above the lidar's
/// plane.
class WalkingBackwards : public ::testing::TestWithParam<double> {
 protected:
  static std::shared_ptr<const World> room(std::vector<Obstacle> obstacles) {
    return std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 5, 4}, 0.0, std::move(obstacles)));
  }
};

TEST_P(WalkingBackwards, SeesWhatItComesToOverEitherShoulder) {
  auto seeing = *test::nao();
  seeing.senses.depth = DepthSense{1.5, 3.0};
  const auto robot = std::make_shared<const Robot>(seeing);
  const Pose start{4.0, 2.0, 0.0};
  Plan plan;
  plan.segments.push_back({translate(0, Sense::kBackward, start, 2.8), 0.0, {}});
  plan.segments.back().closeness.clearance_m = 0.1;
  plan.goal = plan.segments.back().motion.to;
  const auto map = room({});
  sim::SimulatedRobot body(room({{"unmapped", {{1.9, 2.0 + GetParam() * 0.4, 0.42}, {0.6, 0.6, 0.04}, {}}}}),
                           robot, start, 0, 3);
  Executor dut(robot);
  dut.follow(plan, map, *map);
  State state = State::kIdle;
  for (int k = 0; k < 1000 && state != State::kBlocked && !body.truth().has_collided; ++k) {
    const Tick tick = dut.tick(body.sense());
    state = tick.state;
    body.step(tick.command);
  }
  EXPECT_EQ(state, State::kBlocked);
  EXPECT_FALSE(body.truth().has_collided);
  EXPECT_LT(body.truth().pose.x, 3.9);
}

INSTANTIATE_TEST_SUITE_P(FromEitherSide, WalkingBackwards, ::testing::Values(-1.0, 1.0));

}  // namespace
}  // namespace underway
