#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "local/executor.hpp"
#include "sim/robot.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

constexpr Pose kStart{3.0, 1.5, 0.0};
const Motion kBack = translate(0, Sense::kBackward, kStart, 1.0);
const Obstacle kBehind{"behind", {{2.3, 1.5, 0.4}, {0.2, 0.3, 0.8}, {}}};

std::shared_ptr<const World> roomWith(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 5, 3}, 0.0, std::move(obstacles)));
}

Plan planBack() { return timedPlan({{kBack, 25.0, {0.5, {}, {}}}}, kBack.to); }

/// A robot that knows where it is, in an empty room.
class Standing : public ::testing::Test {
 protected:
  Standing() { dut_.expect(*roomWith({}), planBack()); }
  void go(const Velocity& velocity, double time_s) {
    const double until_s = body_.now_s() + time_s;
    while (body_.now_s() < until_s) {
      dut_.see(body_.sense(), body_.truth().pose);
      body_.step({dut_.guarded(velocity), std::nullopt});
    }
  }

  sim::SimulatedRobot body_{roomWith({}), test::nao(), kStart, 0, 1};
  Surroundings dut_{{}, test::nao()};
};

TEST_F(Standing, HasNotSeenTheFloorBehindItAndHasOnceItTurned) {
  go({}, 3.0);
  EXPECT_TRUE(dut_.unseenBehind(kBack, 0.0, kStart).has_value());
  go({0.0, 0.0, 0.17}, 15.0);
  EXPECT_FALSE(dut_.unseenBehind(kBack, 0.0, kStart).has_value());
}

TEST_F(Standing, GoesBackwardsNoFurtherThanItHasSeen) {
  go({-0.04, 0.0, 0.0}, 15.0);
  EXPECT_LT(distance(body_.truth().pose.position(), kStart.position()), 0.2);
}

TEST_F(Standing, GoesToAllOtherSidesAndTurnsWhereItStoodFirst) {
  go({0.0, 0.0, 0.17}, 2.0 * std::numbers::pi / 0.17);
  EXPECT_NEAR(body_.truth().pose.yaw, 0.0, 0.05);
  go({0.06, 0.0, 0.0}, 10.0);
  EXPECT_NEAR(body_.truth().pose.x, 3.6, 0.03);
  go({0.0, 0.035, 0.0}, 20.0);
  EXPECT_NEAR(body_.truth().pose.y, 2.2, 0.05);
}

TEST_F(Standing, GoesBackWhereItCameFrom) {
  go({}, 4.0);
  go({0.06, 0.0, 0.0}, 15.0);
  const double far_x_m = body_.truth().pose.x;
  go({-0.04, 0.0, 0.0}, 20.0);
  EXPECT_NEAR(body_.truth().pose.x, far_x_m - 0.8, 0.05);
}

/// An executor that follows the plan backwards, until it has arrived or is blocked.
struct Backwards {
  explicit Backwards(const std::vector<Obstacle>& unmapped)
      : body(roomWith(unmapped), test::nao(), kStart, 0, 1) {
    dut.follow(planBack(), roomWith({}), *roomWith({}));
    while (body.now_s() < 200.0 && state != State::kArrived && state != State::kBlocked) {
      const Tick tick = dut.tick(body.sense());
      state = tick.state;
      body.step(tick.command);
      if (distance(body.truth().pose.position(), kStart.position()) < 0.1)
        looked_rad = std::max(looked_rad, std::abs(body.truth().pose.yaw));
    }
  }
  sim::SimulatedRobot body;
  Executor dut{test::nao()};
  State state = State::kIdle;
  double looked_rad = 0.0;  // before it had gone 10 cm
};

TEST(Executor, LooksBeforeItGoesBackwardsAndGoes) {
  const Backwards run({});
  EXPECT_EQ(run.state, State::kArrived);
  EXPECT_GT(run.looked_rad, 1.0);
  EXPECT_NEAR(run.body.truth().pose.x, 2.0, 0.05);
}

TEST(Executor, IsBlockedByWhatStandsBehindItAndDoesNotTouchIt) {
  const Backwards run({kBehind});
  EXPECT_EQ(run.state, State::kBlocked);
  EXPECT_FALSE(run.body.truth().has_collided);
}

}  // namespace
}  // namespace underway
