#include "planner/legs.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "planner/roadmap.hpp"
#include "planner/stances.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

constexpr double kPi = std::numbers::pi;

std::shared_ptr<const World> room(std::vector<Obstacle> obstacles = {}) {
  return std::make_shared<const World>(
      *World::make("room", {{-9, -9, 0}, 18, 18}, 0.0, std::move(obstacles)));
}

std::shared_ptr<const Robot> naoWith(const std::function<void(Robot&)>& change) {
  Robot robot = *test::nao();
  change(robot);
  return std::make_shared<const Robot>(*checkedRobot(robot));
}

/// Three modes that change on the spot, from each to the next only, and back to the first.
std::shared_ptr<const Robot> threeInARing(const std::function<void(Robot&)>& change = [](Robot&) {}) {
  return naoWith([&](Robot& r) {
    r.modes = {r.modes[0], r.modes[1], r.modes[0]};
    r.modes[2].name = "third";
    r.switches = {{0, 1, 1.0, {}, {}}, {1, 2, 2.0, {}, {}}, {2, 0, 4.0, {}, {}}};
    change(r);
  });
}

std::uint64_t switchCost_us(const Legs& legs, ModeId from, ModeId to) {
  return legs.changeCost({0.0, from}, {0.0, to}).us();
}

TEST(Legs, ChangeByTheCheapestWayRound) {
  const Checker checker(room(), threeInARing());
  const Legs dut(checker, Policy::kFastest, 0.0, {0, 1, 2});
  EXPECT_NEAR(static_cast<double>(switchCost_us(dut, 0, 1)), 1e6, 10.0);
  EXPECT_NEAR(static_cast<double>(switchCost_us(dut, 0, 2)), 3e6, 10.0);  // over the one between
  EXPECT_NEAR(static_cast<double>(switchCost_us(dut, 1, 0)), 6e6, 10.0);
  EXPECT_EQ(switchCost_us(dut, 1, 1), 0U);
  const auto route = dut.change({0, 0}, {0.0, 0}, {1.0, 2}, 0.02);
  ASSERT_TRUE(route.has_value());
  ASSERT_EQ(route->size(), 3U);
  EXPECT_EQ(route->back().to_mode, 2);
  EXPECT_EQ(route->back().to.yaw, 1.0);
}

TEST(Legs, CannotChangeWhereNoSwitchLeads) {
  const Checker checker(room(), threeInARing([](Robot& r) { r.switches.pop_back(); }));
  const Legs dut(checker, Policy::kFastest, 0.0, {0, 1, 2});
  EXPECT_EQ(dut.changeCost({0.0, 2}, {0.0, 0}), Cost::most());
  EXPECT_FALSE(dut.change({0, 0}, {0.0, 2}, {0.0, 0}, 0.02).has_value());
  EXPECT_EQ(dut.freeChangeCost({0, 0}, {0.0, 2}, {0.0, 0}, 0.02), Cost::most());
}

TEST(Legs, TurnInTheQuickerOfTheTwoModes) {
  for (const bool first_is_quicker : {true, false}) {
    const auto robot = naoWith([&](Robot& r) { r.modes[first_is_quicker ? 0 : 1].turn_speed_radps = 1.0; });
    const Checker checker(room(), robot);
    const Legs dut(checker, Policy::kFastest, 0.0, {0, 1});
    const auto route = dut.change({0, 0}, {0.0, 0}, {1.0, 1}, 0.02);
    ASSERT_TRUE(route.has_value());
    const auto turn = std::find_if(route->begin(), route->end(),
                                   [](const Motion& m) { return m.kind == MotionKind::kTurn; });
    ASSERT_NE(turn, route->end());
    EXPECT_EQ(turn->mode, first_is_quicker ? 0 : 1);
  }
}

TEST(Legs, HaveNoWaysInAModeThatCannotTurnAndCannotChangeItsHeading) {
  const Checker checker(room(), test::nao());
  const Legs dut(checker, Policy::kFastest, 0.0, {2});
  EXPECT_TRUE(dut.ways().empty());
  EXPECT_EQ(dut.changeCost({0.0, 2}, {0.0, 2}), Cost());
  EXPECT_EQ(dut.changeCost({0.0, 2}, {0.1, 2}), Cost::most());
}

/// A switch may need more room than the modes between which it leads, or see what both of them step over.
void expectSwitchIsBlockedBy(const Obstacle& obstacle, const std::shared_ptr<const Robot>& robot, ModeId from,
                             ModeId to) {
  const Checker checker(room({obstacle}), robot);
  const Legs dut(checker, Policy::kFastest, 0.0, Groups(*robot).modes[0]);
  ASSERT_TRUE(dut.has(from) && dut.has(to));
  ASSERT_TRUE(checker.isFree(stay(from, {0, 0, 0})));
  ASSERT_TRUE(checker.isFree(stay(to, {0, 0, 0})));
  EXPECT_EQ(dut.freeChangeCost({0, 0}, {0.0, from}, {0.0, to}, 0.02), Cost::most());
  EXPECT_FALSE(dut.change({0, 0}, {0.0, from}, {0.0, to}, 0.02).has_value());
  const TurningRoom room = dut.roomAt({0, 0}, {0.0, from}, 0.02);
  EXPECT_EQ(dut.freeChangeCost({0, 0}, {0.0, from}, room, {0.0, to}, 0.02), Cost::most());
  EXPECT_FALSE(dut.turnsFreely({0, 0}, 0.02));
}

const Obstacle kAhead{"ahead", {{0.45, 0, 0.5}, {0.2, 0.2, 1.0}, {}}};

TEST(Legs, AreBlockedBySwitchesThatNeedMoreRoomThanEitherMode) {
  const auto robot = naoWith([](Robot& r) {
    r.switches[0].body_m = r.switches[1].body_m = {{-0.5, 0.5}, {-0.2, 0.2}, {0.0, 0.6}};
  });
  expectSwitchIsBlockedBy(kAhead, robot, 0, 1);
}

TEST(Legs, AreBlockedByALargerModeOnTheWay) {
  const auto robot = threeInARing([](Robot& r) { r.modes[1].body_m.x = {-0.5, 0.5}; });
  expectSwitchIsBlockedBy(kAhead, robot, 0, 2);
}

TEST(Legs, AreBlockedByWhatOneModeStepsOverAndTheSwitchDoesNot) {
  // Beside the small body and under the large one's step: the switch, as large as that, sees it.
  const auto robot = naoWith([](Robot& r) {
    r.modes[1].body_m.x = {-0.5, 0.5};
    r.modes[1].step_over_m = 0.1;
    r.switches[0].body_m = r.switches[1].body_m = {};
  });
  const Obstacle curb{"curb", {{0.45, 0, 0.025}, {0.2, 0.2, 0.05}, {}}};
  expectSwitchIsBlockedBy(curb, robot, 0, 1);
  expectSwitchIsBlockedBy(curb, robot, 1, 0);
}

/// A robot whose modes may differ in body, height and step, and whose switches may need room.
std::shared_ptr<const Robot> anyRobot(test::RandomWorld& random) {
  return threeInARing([&](Robot& r) {
    for (Mode& mode : r.modes) {
      if (random.oneOf(2) == 0) mode.body_m.x = {-random.between(0.1, 0.4), random.between(0.1, 0.4)};
      if (random.oneOf(3) == 0) mode.body_m.z.max = random.between(0.2, 0.8);
      if (random.oneOf(3) == 0) mode.step_over_m = random.between(0.0, 0.15);
      mode.turn_speed_radps = random.between(0.1, 1.0);
    }
    if (random.oneOf(3) == 0) r.switches[1].body_m = {{-0.45, 0.45}, {-0.3, 0.3}, {0.0, 0.8}};
  });
}

TEST(Legs, ChangesThatAreSaidToBeFreeAreFreeMotionByMotionAndCostThat) {
  constexpr unsigned kSeed = 1;
  test::RandomWorld random(kSeed);
  int free = 0, blocked = 0;
  for (int round = 0; round < 300; ++round) {
    const auto robot = random.oneOf(3) == 0 ? test::smallRobot() : anyRobot(random);
    const Checker checker(random.world(12), robot);
    const double at_least = random.oneOf(3) == 0 ? 0.05 : 0.0;
    const std::vector<ModeId> companions = Groups(*robot).modes[0];
    const Legs dut(checker, Policy::kFastest, at_least, companions);
    const double keep = std::max(at_least, robot->margin_m);
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round << " case " << i);
      const auto any_mode = [&] {
        return companions[static_cast<std::size_t>(random.oneOf(static_cast<int>(companions.size())))];
      };
      const Point at = random.pose().position();
      const Stance from{random.angle(), any_mode()};
      const Stance to{random.oneOf(4) == 0 ? from.yaw : random.angle(), any_mode()};
      // What arrives and what leaves has been looked at already.
      if (!checker.isFree(stay(from.mode, {at.x, at.y, from.yaw}), keep)) continue;
      if (!checker.isFree(stay(to.mode, {at.x, at.y, to.yaw}), keep)) continue;
      const Cost cost = dut.freeChangeCost(at, from, to, robot->margin_m);
      const TurningRoom room = dut.roomAt(at, from, robot->margin_m);
      ASSERT_EQ(dut.freeChangeCost(at, from, room, to, robot->margin_m), cost);
      if (dut.turnsFreely(at, robot->margin_m)) {
        ASSERT_EQ(cost, dut.changeCost(from, to));
      }
      const auto route = dut.change(at, from, to, robot->margin_m);
      ASSERT_EQ(route.has_value(), cost != Cost::most());
      (route ? free : blocked) += 1;
      if (!route) continue;
      for (const Motion& motion : *route) ASSERT_TRUE(checker.isFree(motion, keep)) << name(motion.kind);
      ASSERT_NEAR(static_cast<double>(costOf(*robot, Policy::kFastest, *route).us()),
                  static_cast<double>(cost.us()), 8.0);
      if (!route->empty()) {
        ASSERT_EQ(route->back().to_mode, to.mode);
        ASSERT_EQ(route->front().from, (Pose{at.x, at.y, from.yaw}));
      }
    }
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(blocked, 100);
}

}  // namespace
}  // namespace underway
