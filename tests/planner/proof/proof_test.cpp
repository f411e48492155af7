#include "planner/proof/proof.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "bench/rooms.hpp"
#include "planner/proof/way.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

namespace underway::proof {
namespace {

using test::nao;
using test::requestFor;

constexpr ModeId kCrawl = 2;

bool isProven(const std::shared_ptr<const World>& world, const Request& request,
              const std::shared_ptr<const Robot>& robot = nao(),
              std::chrono::milliseconds within = std::chrono::seconds(120)) {
  Interrupt interrupt(Interrupt::Clock::now() + within, {});
  return proveNoPath(Checker(world, robot), request, interrupt).has_value();
}

bool isSolved(const std::shared_ptr<const World>& world, const Request& request,
              const std::shared_ptr<const Robot>& robot = nao(),
              std::chrono::milliseconds within = std::chrono::seconds(120)) {
  return Planner(world, robot).plan(request, Interrupt::Clock::now() + within).has_value();
}

std::shared_ptr<const Robot> ourRobot(const std::string& name) {
  return std::make_shared<const Robot>(*readRobot(UNDERWAY_SOURCE_DIR "/robots/" + name + ".yaml"));
}

std::shared_ptr<const World> room(std::vector<Obstacle> obstacles, const Bounds& bounds = {{0, 0, 0}, 6, 4}) {
  return std::make_shared<const World>(*World::make("room", bounds, 0.0, std::move(obstacles)));
}

/// A wall across the room with a gap in its middle.
std::vector<Obstacle> wallWithGap(double gap) {
  const double each = 0.5 * (4.0 - gap);
  return {{"south", {{3.0, 0.5 * each, 0.5}, {0.2, each, 1.0}, {}}},
          {"north", {{3.0, 4.0 - 0.5 * each, 0.5}, {0.2, each, 1.0}, {}}}};
}

TEST(Proof, IsFoundInOurClosedMaps) {
  const Request across = requestFor({0.8, 1.5, 0}, {4.2, 1.5, 0});
  EXPECT_TRUE(isProven(test::ourWorld("too_low"), across));
  EXPECT_TRUE(isProven(test::ourWorld("too_narrow"), across));
  EXPECT_TRUE(isProven(test::ourWorld("walled_in"), requestFor({0.8, 2, 0}, {3, 2, 0})));
  EXPECT_TRUE(isProven(test::ourWorld("walled_in"), requestFor({3, 2, 0}, {0.8, 2, 3.1416})));
}

TEST(Proof, IsFoundForGoalsWithoutAHeadingAndForOtherModes) {
  Request request = requestFor({0.8, 1.5, 0}, {4.2, 1.5, 0});
  request.goal_yaw.reset();
  EXPECT_TRUE(isProven(test::ourWorld("too_narrow"), request));
  request.start_mode = request.goal_mode = kCrawl;
  EXPECT_TRUE(isProven(test::ourWorld("too_low"), request));
}

TEST(Proof, IsNotFoundForQueriesThatOurMapsExpectAPlanFor) {
  for (const char* name : {"scenario1", "scenario2a", "scenario2b", "scenario3", "too_low", "walled_in"}) {
    const auto map = readMap(UNDERWAY_SOURCE_DIR "/maps/" + std::string(name) + ".yaml");
    const auto world = std::make_shared<const World>(map->world);
    for (const Query& query : map->queries) {
      if (query.expect != "ok") continue;
      Request request;
      request.start = query.start;
      request.start_mode = nao()->findMode(query.start_mode).value_or(0);
      request.goal = query.goal;
      request.goal_yaw = query.goal_yaw;
      request.goal_mode = nao()->findMode(query.goal_mode).value_or(0);
      EXPECT_FALSE(isProven(world, request, nao(), std::chrono::milliseconds(100)))
          << name << ": " << query.name;
    }
  }
}

TEST(Proof, OfAClosedPassageIsFoundWhateverIsMissing) {
  for (const bench::Need need : bench::kNeeds) {
    for (const double missing : {0.10, 0.02}) {
      const bench::Room closed = bench::roomWith(need, -missing, 3);
      EXPECT_TRUE(isProven(closed.world, closed.request)) << bench::name(need) << ", " << missing << " m";
    }
  }
}

TEST(Proof, NeverContradictsAPlan) {
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const bench::Room dut =
        seed % 2 == 0 ? bench::clutteredRoom(seed) : bench::roomWith(bench::kNeeds[seed % 5], 0.01, seed);
    if (!isProven(dut.world, dut.request, nao(), std::chrono::milliseconds(100))) continue;
    EXPECT_FALSE(isSolved(dut.world, dut.request, nao(), std::chrono::seconds(1))) << "seed " << seed;
    ++solved;
  }
  EXPECT_LT(solved, 20);
}

TEST(Proof, NeverContradictsAPlanOfRandomRobotsInRandomRooms) {
  test::RandomWorld random(5);
  for (int round = 0; round < 40; ++round) {
    Robot changed = *nao();
    changed.margin_m = random.oneOf(2) == 0 ? 0.0 : 0.02;
    changed.modes[0].body_m.x = {-0.13, 0.13 + random.between(-0.1, 0.1)};
    changed.modes[2].turn_speed_radps = random.oneOf(2) == 0 ? 0.0 : 0.1;
    changed.switches[2].displacement.yaw = random.oneOf(2) == 0 ? 0.0 : random.angle();
    for (Switch& change : changed.switches) change.body_m = {};
    const auto robot = std::make_shared<const Robot>(*checkedRobot(changed));
    const auto world = random.world(14);
    Request request = requestFor(random.pose(), random.pose());
    if (random.oneOf(3) == 0) request.goal_yaw.reset();
    request.start_mode = static_cast<ModeId>(random.oneOf(3));
    request.goal_mode = static_cast<ModeId>(random.oneOf(3));
    if (!isProven(world, request, robot, std::chrono::milliseconds(50))) continue;
    EXPECT_FALSE(isSolved(world, request, robot, std::chrono::milliseconds(200))) << "round " << round;
  }
}

TEST(Proof, HoldsInAnyFrame) {
  for (const double angle : {0.3, 0.785, 2.0, -1.2}) {
    for (const double mirror : {1.0, -1.0}) {
      const Pose frame{-7.0, 11.0, angle};
      const auto moved = [&](const Pose& pose) {
        return compose(frame, {pose.x, mirror * pose.y, mirror * pose.yaw});
      };
      std::vector<Obstacle> walls = wallWithGap(0.28);
      for (Obstacle& wall : walls) {
        const Pose at = moved({wall.box.center_m.x, wall.box.center_m.y, 0.0});
        wall.box.center_m.x = at.x, wall.box.center_m.y = at.y, wall.box.rpy_rad.z = at.yaw;
      }
      const Pose corner = mirror > 0.0 ? moved({0, 0, 0}) : moved({0, 4, 0});
      EXPECT_TRUE(isProven(room(walls, {corner, 6, 4}), requestFor(moved({1, 1, 0.4}), moved({5, 3, 1}))))
          << angle << ", mirrored " << mirror;
      // Bounds that lie across the walls: a room so large that they end in the open.
      EXPECT_FALSE(
          isProven(room(walls, {{-20, -2, 0}, 26, 26}), requestFor(moved({1, 1, 0.4}), moved({5, 3, 1}))));
    }
  }
}

TEST(Proof, IsFoundForOtherRobots) {
  const Request across = requestFor({0.8, 1.5, 0}, {4.2, 1.5, 0});
  EXPECT_TRUE(isProven(test::ourWorld("too_low"), across, ourRobot("nao_obb_paper")));
  const auto tall = ourRobot("tall_biped");
  const auto under = [&](double height) {
    return room({{"beam", {{3.0, 2.0, height + 0.25}, {0.3, 4.0, 0.5}, {}}}});
  };
  const Request request = requestFor({1, 2, 0}, {5, 2, 0});
  EXPECT_TRUE(isProven(under(0.83), request, tall));
  EXPECT_FALSE(isProven(under(0.87), request, tall));
  EXPECT_TRUE(isSolved(under(0.87), request, tall));
}

TEST(Proof, KnowsThatACrawlHasNoWayBack) {
  // A roof over everything: nobody gets up.
  const auto roofed = room({{"roof", {{3.0, 2.0, 0.35}, {6.0, 4.0, 0.2}, {}}}});
  Request request = requestFor({3, 2, 0}, {1, 2, 0});
  request.start_mode = request.goal_mode = kCrawl;
  EXPECT_TRUE(isProven(roofed, request));
  std::swap(request.start.x, request.goal.x);
  EXPECT_FALSE(isProven(roofed, request));
}

TEST(Proof, GrantsATightStartThatItLeavesAsTightly) {
  // In the gap, off its middle: 5 mm on one side, less than the margin, but it stands there.
  const auto narrow = room(wallWithGap(0.29));
  constexpr double kSideways = 1.5707963267948966;
  const Request out = requestFor({3.0, 2.01, kSideways}, {5, 2, 0});
  Interrupt interrupt(test::soon(), {});
  EXPECT_NEAR(leastMargin(Checker(narrow, nao()), out, interrupt), 0.005, 1e-5);
  EXPECT_FALSE(isProven(narrow, out, nao(), std::chrono::milliseconds(500)));
  EXPECT_TRUE(isProven(narrow, requestFor({1, 2, 0}, {5, 2, 0})));
}

TEST(Proof, IsNotNeededWhereStartAndGoalAreOne) {
  EXPECT_FALSE(isProven(test::ourWorld("walled_in"), requestFor({3, 2, 0}, {3, 2, 0})));
  EXPECT_FALSE(isProven(test::ourWorld("walled_in"), requestFor({3, 2, 0}, {3, 2, 2})));
}

TEST(Proof, EndsAtTheDeadlineAndWhenStopped) {
  const bench::Room hard = bench::roomWith(bench::Need::kRunIn, -0.01, 3);
  for (const int ms : {0, 1, 5, 20}) {
    const auto deadline = Interrupt::Clock::now() + std::chrono::milliseconds(ms);
    EXPECT_FALSE(isProven(hard.world, hard.request, nao(), std::chrono::milliseconds(ms)));
    EXPECT_LT(Interrupt::Clock::now() - deadline, std::chrono::milliseconds(200));
  }
  std::stop_source stop;
  stop.request_stop();
  Interrupt interrupt(test::soon(), stop.get_token());
  EXPECT_FALSE(proveNoPath(Checker(hard.world, nao()), hard.request, interrupt));
}

}  // namespace
}  // namespace underway::proof
