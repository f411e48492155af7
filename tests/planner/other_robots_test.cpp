#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "planner/certify.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

// Robots that are not NAO, and ends that are not comfortable.
namespace underway {
namespace {

using test::requestFor;

std::shared_ptr<const World> room(std::vector<Obstacle> obstacles = {}) {
  return std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 6, 4}, 0.0, std::move(obstacles)));
}

std::shared_ptr<const Robot> naoWith(const std::function<void(Robot&)>& change) {
  Robot robot = *test::nao();
  change(robot);
  return std::make_shared<const Robot>(*checkedRobot(robot));
}

void expectSolved(const std::shared_ptr<const World>& world, const std::shared_ptr<const Robot>& robot,
                  const Request& request) {
  Planner dut(world, robot);
  const auto plan = dut.plan(request, test::soon());
  ASSERT_TRUE(plan.has_value()) << plan.error().message;
  for (const Flaw& flaw : certify(*plan, request, *dut.checker()))
    ADD_FAILURE() << "segment " << flaw.segment << " " << flaw.sentence;
}

const Obstacle kBlock{"block", {{3.0, 2.0, 0.5}, {0.4, 2.0, 1.0}, {}}};

TEST(OtherRobots, OneThatHasASingleModeGoesRound) {
  const auto robot = naoWith([](Robot& r) {
    r.modes.resize(1);
    r.modes[0].speed_mps = {0.1, 0.1, 0.1, 0.1};
    r.switches.clear();
    r.margin_m = 0.0;
  });
  expectSolved(room({kBlock}), robot, requestFor({1, 2, 0}, {5, 2, 0}));
}

TEST(OtherRobots, OneThatOnlyGoesBackwardsAndOneOffCentreGoRound) {
  expectSolved(room({kBlock}), naoWith([](Robot& r) {
                 r.modes[0].speed_mps = {0.0, 0.05, 0.0, 0.0};
               }),
               requestFor({1, 2, 0}, {5, 2, 0}));
  expectSolved(room({kBlock}), naoWith([](Robot& r) {
                 for (const std::size_t mode : {0U, 1U})
                   r.modes[mode].body_m = {{-0.3, 0.1}, {-0.1, 0.25}, {0.0, 0.5}};
                 r.switches = {{0, 1, 0.0, {}, {}}, {1, 0, 0.0, {}, {}}};
               }),
               requestFor({1, 2, 0}, {5, 2, 0}));
}

TEST(OtherRobots, ThePapersBoxCrawlsUnderTheTableAndTurnsThere) {
  const auto paper =
      std::make_shared<const Robot>(*readRobot(UNDERWAY_SOURCE_DIR "/robots/nao_obb_paper.yaml"));
  expectSolved(test::ourWorld("scenario3"), paper, requestFor({0.6, 2, 0}, {5.4, 2, 0}));
}

TEST(OtherRobots, OneThatClimbsACurbStepsOverIt) {
  const auto robot = naoWith([](Robot& r) {
    Mode climb = r.modes[0];
    climb.name = "climb";
    climb.step_over_m = 0.2;
    r.modes = {r.modes[0], climb};
    r.switches = {{0, 1, 2.0, {0.05, 0, 0}, {}}, {1, 0, 2.0, {0.05, 0, 0}, {}}};
  });
  const Obstacle curb{"curb", {{3.0, 2.0, 0.05}, {0.2, 4.0, 0.1}, {}}};
  expectSolved(room({curb}), robot, requestFor({1, 1, 0}, {5, 3, 1.0}));
}

TEST(OtherRobots, OneThatCannotMoveTurnsAndOneThatCannotTurnGoesStraightOn) {
  const auto only_turns = naoWith([](Robot& r) {
    r.modes.resize(1);
    r.modes[0].speed_mps = {};
    r.switches.clear();
  });
  expectSolved(room(), only_turns, requestFor({1, 2, 0}, {1, 2, 2.0}));
  const auto never_turns = naoWith([](Robot& r) {
    for (Mode& mode : r.modes) mode.turn_speed_radps = 0.0;
  });
  expectSolved(room(), never_turns,
               requestFor({1, 2, 0.3}, {1 + 2 * std::cos(0.3), 2 + 2 * std::sin(0.3), 0.3}));
}

TEST(OtherRobots, OneWhoseSwitchesTurnItCrawlsUnderATableAndMayStayThere) {
  const auto robot = naoWith([](Robot& r) {
    for (Switch& change : r.switches) {
      if (change.from != 2 && change.to != 2) continue;
      change.displacement.yaw = 0.7;
      change.body_m = {{-0.5, 0.7}, {-0.5, 0.5}, {0.0, 0.585}};
    }
  });
  const auto under = room({{"table", {{3.0, 2.0, 0.45}, {0.4, 4.0, 0.4}, {}}}});
  for (const Policy policy : {Policy::kPriority, Policy::kFastest, Policy::kSafest}) {
    expectSolved(under, robot, requestFor({1, 2, 0}, {5, 2, 0}, policy));
    Request in = requestFor({1, 2, 0}, {3, 2, 0}, policy);
    in.goal_mode = 2;
    expectSolved(under, robot, in);
    Request out = requestFor({3, 2, 0}, {5, 2, 0}, policy);
    out.start_mode = 2;
    expectSolved(under, robot, out);
  }
}

TEST(Ends, ACrawlIsThereAlreadyIfTheGoalIsWithinTheToleranceBehindIt) {
  const Obstacle roof{"roof", {{3.0, 2.0, 0.35}, {6.0, 4.0, 0.2}, {}}};
  for (const double behind : {0.0, 1e-9, 1e-7, 1e-3, 0.008}) {
    Request request = requestFor({2, 2, 0}, {2 - behind, 2, 0});
    request.start_mode = request.goal_mode = 2;
    expectSolved(room({roof}), test::nao(), request);
  }
}

TEST(Ends, ATightGoalIsReachedAtWhicheverHeadingIsLeftOpen) {
  // The clearance at the goal depends on the heading there; what comes before it must keep that.
  const double gap = 0.26 + 2 * 0.012;
  const std::vector<Obstacle> slot{{"south", {{3.0, 1.0 - 0.5 * gap, 0.5}, {1.0, 2.0, 1.0}, {}}},
                                   {"north", {{3.0, 3.0 + 0.5 * gap, 0.5}, {1.0, 2.0, 1.0}, {}}}};
  Request request = requestFor({1, 2, 0}, {2.4, 2, 0});
  request.goal_yaw.reset();
  for (const double x : {2.3, 2.34, 2.36, 2.38}) {
    request.goal.x = x;
    expectSolved(room(slot), test::nao(), request);
  }
}

TEST(Ends, GoalsWithoutAHeadingAreReachedInAModeThatCannotTurn) {
  Request request = requestFor({1, 2, 0}, {4, 2, 0});
  request.goal_yaw.reset();
  request.goal_mode = 2;
  expectSolved(room(), test::nao(), request);
}

TEST(Ends, ACrawlGoesStraightOnToAGoalWithinTheTolerance) {
  // A roof over everything: no other mode fits.
  const Obstacle roof{"roof", {{3.0, 2.0, 0.35}, {6.0, 4.0, 0.2}, {}}};
  Request request = requestFor({1, 2, 0}, {3, 2.005, 2.0 * std::numbers::pi});
  request.start_mode = request.goal_mode = 2;
  expectSolved(room({roof}), test::nao(), request);
}

TEST(Ends, UnderARoofThatIsFlushWithTheBodyNothingIsFree) {
  // Its underside is exactly as high as the body, which is touching, whatever the floor's height is.
  for (const double floor : {0.0, 0.1, 0.3, -1.7, 2.9}) {
    const Obstacle roof{"roof", {{3.0, 2.0, floor + 0.585 + 0.1}, {6.0, 4.0, 0.2}, {}}};
    const auto world =
        std::make_shared<const World>(*World::make("roofed", {{0, 0, 0}, 6, 4}, floor, {roof}));
    Planner dut(world, test::nao());
    const auto plan = dut.plan(requestFor({1, 2, 0}, {5, 2, 0}), test::soon());
    ASSERT_FALSE(plan.has_value()) << "floor " << floor;
    EXPECT_EQ(plan.error().code, ErrorCode::kStartInCollision) << "floor " << floor;
  }
}

TEST(Ends, HeadingsGivenInManyRevolutionsAreUnderstoodAndAbsurdOnesRefused) {
  expectSolved(room({kBlock}), test::nao(), requestFor({1, 2, 7.0}, {5, 2, -40.0}));
  Planner dut(room(), test::nao());
  EXPECT_EQ(dut.plan(requestFor({1, 2, 1e9}, {5, 2, 0}), test::soon()).error().code,
            ErrorCode::kInvalidRequest);
}

TEST(Ends, ATightGoalAtTheStartsOwnPositionIsReached) {
  // 5 cm from a wall the body may turn a little; both headings are closer than the margin asks for, or not.
  const Obstacle wall{"wall", {{2.275, 2.0, 0.5}, {0.15, 4.0, 1.0}, {}}};
  expectSolved(room({wall}), test::nao(), requestFor({2.5, 2, 0}, {2.5, 2, 0.1}));
}

/// Random rooms, robots and ends: whatever is answered is certified, and nothing ends as an internal fault.
TEST(Ends, OfRandomQueriesNoneEndsInAFaultOfOurOwn) {
  test::RandomWorld random(11);
  for (int round = 0; round < 60; ++round) {
    const auto robot = naoWith([&](Robot& r) {
      r.margin_m = random.oneOf(2) == 0 ? 0.0 : 0.02;
      const double asymmetry = random.between(-0.05, 0.05);
      r.modes[0].body_m.x = {-0.13, 0.13 + asymmetry};
      r.switches[0].body_m = r.switches[1].body_m = {};
    });
    Planner dut(random.world(8), robot);
    Request request = requestFor(random.pose(), random.pose(), static_cast<Policy>(random.oneOf(3)));
    if (random.oneOf(3) == 0) request.goal_yaw.reset();
    request.start_mode = static_cast<ModeId>(random.oneOf(3));
    request.goal_mode = static_cast<ModeId>(random.oneOf(3));
    const auto plan = dut.plan(request, Planner::Clock::now() + std::chrono::milliseconds(500));
    if (plan) continue;
    EXPECT_NE(plan.error().code, ErrorCode::kInternal) << "round " << round << ": " << plan.error().message;
  }
}

}  // namespace
}  // namespace underway
