#include "local/mission.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "sim/robot.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using Outcome = Mission::Outcome;

/// Drives until the mission ends or the time is over.
Outcome drive(Mission& mission, sim::SimulatedRobot& body, double limit_s) {
  while (mission.outcome() == Outcome::kUnderway && body.now_s() < limit_s)
    body.step(mission.tick(body.sense()).command);
  return mission.outcome();
}

const Pose kStart{0.6, 0.6, 0.0};
const Pose kGoal{4.4, 0.6, 0.0};
std::shared_ptr<const World> roomWith(std::vector<Obstacle> obstacles) {
  // Walls outside of 5 x 3 m: bounds alone would be seen by nobody.
  obstacles.push_back({"south", {{2.5, -0.1, 0.4}, {5.4, 0.2, 0.8}, {}}});
  obstacles.push_back({"north", {{2.5, 3.1, 0.4}, {5.4, 0.2, 0.8}, {}}});
  obstacles.push_back({"west", {{-0.1, 1.5, 0.4}, {0.2, 3.0, 0.8}, {}}});
  obstacles.push_back({"east", {{5.1, 1.5, 0.4}, {0.2, 3.0, 0.8}, {}}});
  return std::make_shared<const World>(
      *World::make("room", {{-0.2, -0.2, 0}, 5.4, 3.4}, 0.0, std::move(obstacles)));
}
const Obstacle kBox{"box", {{2.5, 0.6, 0.4}, {0.3, 0.5, 0.8}, {}}};
const Obstacle kWall{"wall", {{2.5, 1.5, 0.4}, {0.1, 2.98, 0.8}, {}}};

/// A planner in this process, and how often it was asked.
struct Source {
  std::shared_ptr<const Robot> robot = test::nao();
  int asked = 0;
  Expected<Plan> operator()(const Request& request, const std::shared_ptr<const World>& world) {
    ++asked;
    return Planner(world, robot).findPlan(request, Planner::Clock::now() + std::chrono::seconds(1));
  }
};

TEST(Mission, GoesRoundWhatIsNotInTheMap) {
  const auto map = roomWith({});
  Source source;
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), std::ref(source));
  sim::SimulatedRobot body(roomWith({kBox}), test::nao(), kStart, 0, 1);
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kArrived) << dut.why();
  EXPECT_FALSE(body.truth().has_collided);
  EXPECT_FALSE(body.truth().is_disputed);
  EXPECT_LT(distance(body.truth().pose.position(), kGoal.position()), 0.05);
}

/// Beyond a narrow passage, sideways, the map's plan turns where a corner swings over floor behind the wall
/// that no beam has passed: nobody can look there before. So it goes on before it turns.
TEST(Mission, TurnsWhereTheFloorWasSeen) {
  const auto map = test::ourWorld("scenario2a");
  const Pose start{0.6, 2.0, 0.0};
  Source source;
  Mission dut(map, test::nao(), test::requestFor(start, {5.4, 2.0, 0.0}), std::ref(source));
  sim::SimulatedRobot body(map, test::nao(), start, 0, 3);
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kArrived) << dut.why();
  EXPECT_FALSE(body.truth().has_collided);
}

TEST(Mission, ReportsThatThereIsNoWayRound) {
  const auto map = roomWith({});
  Source source;
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), std::ref(source));
  sim::SimulatedRobot body(roomWith({kWall}), test::nao(), kStart, 0, 1);
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kNoWay);
  EXPECT_FALSE(body.truth().has_collided);
  EXPECT_FALSE(body.truth().is_disputed);
  EXPECT_FALSE(dut.why().empty());
  EXPECT_GT(dut.world()->obstacles().size(), 0U);  // what was seen is in the world
}

TEST(Mission, CrawlsFurtherFromWhatItSawWherePlansCrawlBesideIt) {
  const auto map = test::ourWorld("scenario3");
  const Pose start{0.6, 2.0, 0.0};
  auto truth = *map;
  for (const double y : {1.62, 2.38})  // before the table, to either side of where the map's plan lies down
    truth = *truth.added({"unmapped " + std::to_string(y), {{2.95, y, 0.3}, {0.1, 0.1, 0.6}, {}}});
  Source source;
  Mission dut(map, test::nao(), test::requestFor(start, {5.4, 2.0, 0.0}), std::ref(source));
  sim::SimulatedRobot body(std::make_shared<const World>(truth), test::nao(), start, 0, 1);
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kArrived) << dut.why();
  EXPECT_FALSE(body.truth().has_collided);
  EXPECT_FALSE(body.truth().is_disputed);
}

TEST(Mission, DoesNotGoToAndFroForEverBetweenTwoBlockedWays) {
  const auto hallWith = [](std::vector<Obstacle> obstacles) {
    obstacles.push_back({"block", {{6.0, 1.5, 0.4}, {8.0, 0.6, 0.8}, {}}});
    return std::make_shared<const World>(*World::make("hall", {{0, 0, 0}, 12, 3}, 0.0, std::move(obstacles)));
  };
  const auto closing = [](const char* id, double y) {
    return Obstacle{id, {{6.0, y, 0.4}, {0.3, 1.18, 0.8}, {}}};
  };
  Source source;
  Mission dut(hallWith({}), test::nao(), test::requestFor({1.0, 1.5, 0.0}, {11.0, 1.5, 0.0}),
              std::ref(source));
  sim::SimulatedRobot body(hallWith({closing("south", 0.6), closing("north", 2.4)}), test::nao(),
                           {1.0, 1.5, 0.0}, 0, 1);
  EXPECT_EQ(drive(dut, body, 3000.0), Outcome::kNoWay);
  EXPECT_LT(body.now_s(), 2000.0);
  EXPECT_FALSE(body.truth().has_collided);
}

TEST(Mission, AsksTheSameUntilTheAnswerIsThere) {
  const auto map = roomWith({});
  Source source;
  std::shared_ptr<const World> asked_in;
  Pose asked_from;
  int ticks = 0;
  int questions = 0;
  const auto late = [&](const Request& request, const std::shared_ptr<const World>& world) -> Expected<Plan> {
    if (ticks == 0) asked_in = world, asked_from = request.start, ++questions;
    EXPECT_EQ(world, asked_in);
    EXPECT_EQ(request.start, asked_from);
    if (++ticks < 15) return fail(ErrorCode::kBusy, "on its way");
    ticks = 0;
    return source(request, world);
  };
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), late);
  sim::SimulatedRobot body(roomWith({kBox}), test::nao(), kStart, 0, 1);
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kArrived) << dut.why();
  EXPECT_FALSE(body.truth().has_collided);
  EXPECT_GT(questions, 1);
}

TEST(Mission, WantsHelpWhereLocalisationComesTooSeldom) {
  const auto map = roomWith({});
  Source source;
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), std::ref(source));
  sim::SimulatedRobot body(map, test::nao(), kStart, 0, 1);
  for (int k = 0; k < 600 && dut.outcome() == Outcome::kUnderway; ++k) {
    Senses senses = body.sense();
    if (k % 20 != 0) senses.pose.reset();
    body.step(dut.tick(senses).command);
  }
  EXPECT_EQ(dut.outcome(), Outcome::kNeedsHelp);
  EXPECT_NE(dut.why().find("localisation"), std::string::npos) << dut.why();
  EXPECT_EQ(body.truth().pose, kStart);
}

TEST(Mission, StandsStillWhileTheServerIsGoneAndAsksAgain) {
  const auto map = roomWith({});
  Source source;
  int asked = 0;
  const auto gone = [&](const Request& request, const std::shared_ptr<const World>& world) -> Expected<Plan> {
    if (++asked <= 5) return fail(ErrorCode::kNoServer, "no server answers");
    return source(request, world);
  };
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), gone);
  sim::SimulatedRobot body(map, test::nao(), kStart, 0, 1);
  for (int k = 0; k < 30; ++k) body.step(dut.tick(body.sense()).command);
  EXPECT_EQ(body.truth().pose, kStart);
  EXPECT_EQ(dut.why(), "no server answers");
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kArrived);
}

TEST(Mission, StandsStillWhileThePlanIsOnItsWayAndAsksWithEveryTick) {
  const auto map = roomWith({});
  Source source;
  int asked = 0;
  const auto slow = [&](const Request& request, const std::shared_ptr<const World>& world) -> Expected<Plan> {
    if (++asked <= 50) return fail(ErrorCode::kBusy, "it is being planned");
    return source(request, world);
  };
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), slow);
  sim::SimulatedRobot body(map, test::nao(), kStart, 0, 1);
  for (int k = 0; k < 50; ++k) body.step(dut.tick(body.sense()).command);
  EXPECT_EQ(asked, 50);
  EXPECT_EQ(dut.outcome(), Outcome::kUnderway);
  EXPECT_EQ(body.truth().pose, kStart);
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kArrived);
}

TEST(Mission, FollowsAPlanThatItHasWithoutTheServer) {
  const auto map = roomWith({});
  Source source;
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), std::ref(source));
  sim::SimulatedRobot body(map, test::nao(), kStart, 0, 1);
  EXPECT_EQ(drive(dut, body, 900.0), Outcome::kArrived);
  EXPECT_EQ(source.asked, 1);
}

TEST(Mission, WantsHelpWhenTheRobotHasFallen) {
  const auto map = roomWith({});
  Source source;
  Mission dut(map, test::nao(), test::requestFor(kStart, kGoal), std::ref(source));
  sim::SimulatedRobot body(map, test::nao(), kStart, 0, 1);
  for (int k = 0; k < 100; ++k) body.step(dut.tick(body.sense()).command);
  body.fall();
  EXPECT_EQ(drive(dut, body, 60.0), Outcome::kNeedsHelp);
}

}  // namespace
}  // namespace underway
