#include "local/surroundings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "local/lane.hpp"
#include "sim/robot.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

/// A robot that stands still in scenario 1 and looks, with a plan for straight on.
class Looking : public ::testing::Test {
 protected:
  void look(const std::vector<Obstacle>& unmapped, int ticks = 20) {
    World truth = *map_;
    for (const Obstacle& obstacle : unmapped) truth = *truth.added(obstacle);
    sim::SimulatedRobot body(std::make_shared<const World>(truth), test::nao(), kHere, 0, 1);
    dut_.expect(*map_, plan_);
    for (int k = 0; k < ticks; ++k) {
      dut_.see(body.sense(), kHere);
      body.step({});
    }
  }

  static constexpr Pose kHere{0.6, 0.6, 0.0};
  std::shared_ptr<const World> map_ = test::ourWorld("scenario1");
  Motion ahead_ = translate(0, Sense::kForward, kHere, 1.5);
  Plan plan_ = timedPlan({{ahead_, 20.0, {0.1, {}, {}}}}, kHere);
  Surroundings dut_{{}, test::nao()};
};

const Obstacle kBox{"box", {{1.5, 0.6, 0.3}, {0.2, 0.2, 0.6}, {}}};

TEST_F(Looking, IsNotSurprisedByTheMap) {
  look({}, 200);
  EXPECT_TRUE(dut_.surprisesNear({0.6, 0.6}, 3.0).empty());
  EXPECT_FALSE(dut_.isLaneBlocked(ahead_, 0.0));
}

TEST_F(Looking, FindsTheLaneBlockedByWhatIsNotInTheMap) {
  look({kBox});
  EXPECT_FALSE(dut_.surprisesNear({1.5, 0.6}, 0.3).empty());
  EXPECT_TRUE(dut_.isLaneBlocked(ahead_, 0.0));
  EXPECT_FALSE(dut_.isLaneBlocked(shifted(ahead_, 0.6), 0.0));
}

TEST_F(Looking, FindsAWayRoundWhereThereIsRoom) {
  look({kBox});
  const auto shift = dut_.shiftAround(ahead_, 0.0, 0.6);
  ASSERT_TRUE(shift.has_value());
  EXPECT_GT(std::abs(*shift), 0.2);
  EXPECT_FALSE(dut_.shiftAround(ahead_, 0.0, 0.1).has_value());
}

TEST_F(Looking, IsSurprisedOnceByEachThing) {
  look({kBox});
  dut_.markKnown();  // whoever is asked for a new plan is told of it
  dut_.expect(*map_, plan_);
  EXPECT_FALSE(dut_.isLaneBlocked(ahead_, 0.0));
  EXPECT_FALSE(dut_.surprisesNear({1.5, 0.6}, 0.3).empty());
}

TEST_F(Looking, DoesNotSeeATableTopAboveTheLidarsPlane) {
  look({{"top", {{1.5, 0.6, 0.45}, {0.4, 0.4, 0.04}, {}}}});
  EXPECT_FALSE(dut_.isLaneBlocked(ahead_, 0.0));
}

TEST_F(Looking, DoesNotRunIntoWhatItSees) {
  look({{"near", {{0.88, 0.6, 0.3}, {0.2, 0.2, 0.6}, {}}}});
  EXPECT_LT(dut_.guarded({0.068, 0.0, 0.0}).x_mps, 0.068);
  EXPECT_EQ(dut_.guarded({-0.04, 0.0, 0.0}), (Velocity{-0.04, 0.0, 0.0}));
}

std::shared_ptr<const World> roomWith(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 10, 10}, 0.0, std::move(obstacles)));
}
const Obstacle kWall{"wall", {{5.0, 0.5, 0.4}, {10.0, 0.2, 0.8}, {}}};

/// A robot whose belief trembles as it does with localisation, in a room whose map has a wall.
struct Trembling {
  Trembling(const std::vector<Obstacle>& unmapped, const Pose& start, unsigned seed)
      : body(worldWith(unmapped), test::nao(), start, 0, seed), random(seed) {
    dut.expect(*roomWith({kWall}),
               timedPlan({{translate(0, Sense::kForward, start, 0.5), 10.0, {0.1, {}, {}}}}, start));
  }
  static std::shared_ptr<const World> worldWith(std::vector<Obstacle> obstacles) {
    obstacles.push_back(kWall);
    return roomWith(std::move(obstacles));
  }
  void go(const Velocity& wanted, double time_s) {
    const double until_s = body.now_s() + time_s;
    while (body.now_s() < until_s && !body.truth().has_collided) {
      const Pose& at = body.truth().pose;
      dut.see(body.sense(), {at.x + tremble(random), at.y + tremble(random), at.yaw + tremble(random)});
      body.step({dut.guarded(wanted), std::nullopt});
    }
  }
  sim::SimulatedRobot body;
  Surroundings dut{{}, test::nao()};
  std::mt19937 random;
  std::normal_distribution<double> tremble{0.0, 0.004};
};

TEST(Surroundings, AreNotTouchedWhateverTheRobotIsToldAndHoweverItsBeliefTrembles) {
  constexpr double kTurn_s = 40.0;  // once round, to look
  std::uniform_real_distribution<double> even(0.0, 1.0);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double least_moved_m = 1e9;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    std::vector<Obstacle> things;
    for (int k = 0; k < 3; ++k) {
      const double bearing = std::numbers::pi * even(random);
      const double range = 0.42 + 0.3 * even(random);
      things.push_back({"box_" + std::to_string(k),
                        {{5.0 + range * std::cos(bearing), 5.0 + range * std::sin(bearing), 0.4},
                         {0.1 + 0.1 * even(random), 0.1 + 0.1 * even(random), 0.8},
                         {0.0, 0.0, 3.0 * even(random)}}});
    }
    Trembling robot(things, {5.0, 5.0, 0.0}, seed);
    robot.go({0.0, 0.0, 0.17}, kTurn_s);
    for (int k = 0; k < 15; ++k) robot.go({0.06 * any(random), 0.04 * any(random), 0.17 * any(random)}, 8.0);
    const sim::Truth& truth = robot.body.truth();
    EXPECT_FALSE(truth.has_collided) << "seed " << seed << ", with " << truth.with;
    least_moved_m = std::min(least_moved_m, truth.moved_m);
  }
  EXPECT_GT(least_moved_m, 0.02);  // it is not safe by standing still
}

TEST(Surroundings, KeepAsFarFromAMappedWallAsThePlanLeavesRoomFor) {
  constexpr double kSide_m = 0.195;
  constexpr double kFace_m = 0.6;
  const auto nearest = [&](double clearance_m, unsigned seed) {
    Trembling robot({}, {2.0, kFace_m + kSide_m + 0.09, 0.0}, seed);
    robot.dut.passBy(clearance_m);
    robot.go({0.0, 0.0, 0.0}, 2.0);
    robot.go({0.0, -0.02, 0.0}, 20.0);
    EXPECT_FALSE(robot.body.truth().has_collided) << "seed " << seed;
    return robot.body.truth().pose.y - kSide_m - kFace_m;
  };
  for (unsigned seed = 1; seed <= 20; ++seed) {
    EXPECT_GT(nearest(0.09, seed), 0.01) << "seed " << seed;
    EXPECT_GT(nearest(0.09, seed), nearest(0.02, seed) + 0.005) << "seed " << seed;
  }
}

/// So close to a wall that the map's tolerance takes it for the wall.
TEST(Surroundings, AreNotTouchedWhereTheyStandThreeCentimetresBeforeTheMapsWall) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Trembling robot({{"plate", {{2.6, 0.615, 0.4}, {0.3, 0.03, 0.8}, {}}}}, {1.5, 0.6 + 0.195 + 0.02, 0.0},
                    seed);
    robot.go({0.05, 0.0, 0.0}, 60.0);
    EXPECT_FALSE(robot.body.truth().has_collided) << "seed " << seed;
    EXPECT_GT(robot.body.truth().pose.x, 1.6) << "seed " << seed;
  }
}

}  // namespace
}  // namespace underway
