#include <gtest/gtest.h>

#include "planner/certify.hpp"
#include "planner/planner.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

struct Case {
  std::shared_ptr<const World> world;
  std::shared_ptr<const Robot> robot;
  Request request;
};

/// That there is a sound plan by kSafest, and that it comes no closer than the fastest.
void expectSafest(const Case& room) {
  Planner dut(room.world, room.robot);
  Request request = room.request;
  request.policy = Policy::kFastest;
  const auto fastest = dut.plan(request, test::soon());
  if (!fastest) return;
  request.policy = Policy::kSafest;
  const auto safest = dut.plan(request, test::soon());
  ASSERT_TRUE(safest) << safest.error().message;
  EXPECT_TRUE(certify(*safest, request, *dut.checker()).empty());
  EXPECT_GE(leastClearance(*safest), std::min(leastClearance(*fastest), kEnoughClearance_m) - 1e-9);
}

TEST(Safest, LeavesAStartBesideACornerThatIsNearerThanItsGrownBodyReaches) {
  // The corner is 4.7 cm away; a body grown by that to all sides would touch it.
  const auto world = World::make("two", {{0, 0, 0}, 5, 4}, -1.5,
                                 {{"o1",
                                   {{3.6957478465592546, 1.7768292034224444, -1.0347949717060754},
                                    {0.2927577652578664, 0.5261748168361621, 0.5933499220710047},
                                    {}}},
                                  {"o4",
                                   {{0.9896281983845362, 2.4173075250910903, -1.3712096214902978},
                                    {0.5228497092148481, 0.19652668281825442, 0.45853178762368635},
                                    {-2.4384313713146604, -0.033439467042281734, -2.0743344134318935}}}});
  Request request = test::requestFor({1.2401699793161358, 1.9226658464776336, -1.4437499643549936}, {});
  request.goal = {4.110608179256379, 1.1223331816696405};
  request.goal_yaw.reset();
  expectSafest({std::make_shared<const World>(*world), test::nao(), request});
}

TEST(Safest, HasAPlanWhereverFastestHasOne) {
  constexpr unsigned kSeed = 2;
  test::RandomWorld random(kSeed);
  for (int round = 0; round < 30; ++round) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + " round " + std::to_string(round));
    std::vector<Obstacle> obstacles;
    for (std::size_t i = 0, count = 2 + random.oneOf(5); i < count; ++i)
      obstacles.push_back({"box_" + std::to_string(i), random.box(true)});
    const auto world = World::make("room", {{-1.0, -1.0, 0.0}, 6.0, 6.0}, 0.0, std::move(obstacles));
    const Request request = test::requestFor(random.pose(), random.pose());
    const Checker checker(std::make_shared<const World>(*world), test::smallRobot());
    if (!checker.isFree(stay(0, request.start)) ||
        !checker.isFree(stay(0, {request.goal.x, request.goal.y, *request.goal_yaw})))
      continue;
    Planner probe(std::make_shared<const World>(*world), test::smallRobot());
    Request fastest = request;
    fastest.policy = Policy::kFastest;
    if (!probe.plan(fastest, Planner::Clock::now() + std::chrono::seconds(1))) continue;
    expectSafest({std::make_shared<const World>(*world), test::smallRobot(), request});
  }
}

}  // namespace
}  // namespace underway
