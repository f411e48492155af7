// What the executor does about things that came under a table, with a lidar that works lying and without; and
// about table tops, with a camera that sees all heights.

#include <gtest/gtest.h>

#include <functional>

#include "local/mission.hpp"
#include "sim/robot.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

std::shared_ptr<const Robot> naoWith(const std::function<void(SensesOfRobot&)>& senses) {
  Robot robot = *test::nao();
  senses(robot.senses);
  return std::make_shared<const Robot>(robot);
}
std::shared_ptr<const Robot> naoWithHead() {
  return naoWith([](SensesOfRobot& senses) { senses.head = LidarSense{0.15}; });
}

constexpr Pose kStart{0.6, 2.0, 0.0};
constexpr Pose kGoal{5.4, 2.0, 0.0};

/// Scenario 3, which leads under a table, with a thing in it that the map does not have: too low for a lidar
/// at the waist.
struct UnderTheTable {
  UnderTheTable(const std::shared_ptr<const Robot>& robot, const OrientedBox& thing)
      : body(std::make_shared<const World>(*map->added({"thing", thing})), robot, kStart, 0, 11),
        plan(*Planner(map, robot).plan(test::requestFor(kStart, kGoal), test::soon())),
        dut(robot) {
    dut.follow(plan, map, *map);
  }

  /// Until it has arrived, stalled or collided.
  State run() {
    while (dut.state() != State::kArrived && dut.state() != State::kStalled && !body.truth().has_collided &&
           body.now_s() < 600.0)
      body.step(dut.tick(body.sense()).command);
    return dut.state();
  }

  std::shared_ptr<const World> map = test::ourWorld("scenario3");
  sim::SimulatedRobot body;
  Plan plan;
  Executor dut;
};

/// Across the middle of the crawl, or where the plan has it get up.
OrientedBox lowThingAt(Point at) { return {{at.x, at.y, 0.1}, {0.1, 0.3, 0.2}, {}}; }
OrientedBox thingInTheCrawl() { return lowThingAt({4.1, 2.0}); }

TEST(Lying, WithItsHeadSeesWhatCameUnderTheTableStopsAndReports) {
  UnderTheTable run(naoWithHead(), thingInTheCrawl());
  EXPECT_EQ(run.run(), State::kStalled);
  EXPECT_FALSE(run.body.truth().has_collided);
  EXPECT_FALSE(run.body.truth().is_disputed);
  EXPECT_EQ(run.dut.whyStalled(), "something that is not in the map lies in its way");
  EXPECT_FALSE(run.dut.surprises().empty());
  EXPECT_EQ(run.dut.tick(run.body.sense()).command, Command{});
}

TEST(Lying, WithItsWaistAloneIsBlindAndTouchesIt) {
  UnderTheTable run(test::nao(), thingInTheCrawl());
  run.run();
  EXPECT_TRUE(run.body.truth().has_collided);
  EXPECT_EQ(run.body.truth().with, "thing");
}

TEST(Lying, WithItsHeadArrivesWhereNothingCame) {
  UnderTheTable run(naoWithHead(), lowThingAt({0.3, 0.3}));
  EXPECT_EQ(run.run(), State::kArrived);
  EXPECT_FALSE(run.body.truth().has_collided);
}

TEST(Lying, WithItsHeadDoesNotGetUpBesideWhatItSees) {
  const auto robot = naoWithHead();
  const Plan plan =
      *Planner(test::ourWorld("scenario3"), robot).plan(test::requestFor(kStart, kGoal), test::soon());
  Pose up;
  for (const Segment& segment : plan.segments)
    if (segment.motion.kind == MotionKind::kSwitch && segment.motion.mode == 2) up = segment.motion.from;
  // Where the standing body would be, and beside the crawl's lane.
  UnderTheTable run(robot, lowThingAt(transform(up, {0.1, 0.36})));
  run.run();
  EXPECT_FALSE(run.body.truth().has_collided) << run.body.truth().with;
}

TEST(Lying, TheMissionWantsHelpAndSaysWhy) {
  const auto robot = naoWithHead();
  const auto map = test::ourWorld("scenario3");
  const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
    return Planner(world, robot).findPlan(request, test::soon());
  };
  Mission dut(map, robot, test::requestFor(kStart, kGoal), source);
  sim::SimulatedRobot body(std::make_shared<const World>(*map->added({"thing", thingInTheCrawl()})), robot,
                           kStart, 0, 11);
  while (dut.outcome() == Mission::Outcome::kUnderway && body.now_s() < 600.0)
    body.step(dut.tick(body.sense()).command);
  EXPECT_EQ(dut.outcome(), Mission::Outcome::kNeedsHelp);
  EXPECT_NE(dut.why().find("something that is not in the map lies in its way"), std::string::npos)
      << dut.why();
  EXPECT_FALSE(body.truth().has_collided);
}

/// A room with a table in the way whose top a lidar at the waist does not see and a standing NAO does not fit
/// under.
struct RoomWithTable {
  std::shared_ptr<const World> map =
      std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 5, 3}, 0.0, {}));
  std::shared_ptr<const World> truth =
      std::make_shared<const World>(*map->added({"top", {{2.5, 1.0, 0.45}, {0.5, 0.5, 0.04}, {}}}));
  Pose start{0.6, 1.0, 0.0};
  Pose goal{4.4, 1.0, 0.0};

  sim::Truth drive(const std::shared_ptr<const Robot>& robot, Mission::Outcome& outcome) const {
    const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
      return Planner(world, robot).findPlan(request, Planner::Clock::now() + std::chrono::seconds(2));
    };
    Mission mission(map, robot, test::requestFor(start, goal), source);
    sim::SimulatedRobot body(truth, robot, start, 0, 1);
    while (mission.outcome() == Mission::Outcome::kUnderway && !body.truth().has_collided &&
           body.now_s() < 900.0)
      body.step(mission.tick(body.sense()).command);
    outcome = mission.outcome();
    return body.truth();
  }
};

TEST(Depth, LeadsRoundATableTopThatAWaistDoesNotSee) {
  const RoomWithTable room;
  auto outcome = Mission::Outcome::kUnderway;
  const auto truth = room.drive(naoWith([](SensesOfRobot& senses) {
                                  senses.depth = DepthSense{1.5, 3.0};
                                }),
                                outcome);
  EXPECT_EQ(outcome, Mission::Outcome::kArrived);
  EXPECT_FALSE(truth.has_collided) << truth.with;
  EXPECT_FALSE(truth.is_disputed);
}

TEST(Depth, IsWhatItTakes) {
  const RoomWithTable room;
  auto outcome = Mission::Outcome::kUnderway;
  EXPECT_TRUE(room.drive(test::nao(), outcome).has_collided);
}

}  // namespace
}  // namespace underway
