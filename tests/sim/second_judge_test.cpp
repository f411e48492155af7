#include "sim/second_judge.hpp"

#include <gtest/gtest.h>

#include "geometry/checker.hpp"
#include "tests/geometry/random_world.hpp"

namespace underway::sim {
namespace {

std::shared_ptr<const World> roomWith(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(
      *World::make("room", {{-5, -5, 0}, 10, 10}, 0.0, std::move(obstacles)));
}

const Obstacle kWall{"wall", {{1.05, 0.0, 0.5}, {0.1, 2.0, 1.0}, {}}};
const Obstacle kTop{"top", {{0.0, 0.0, 0.32}, {0.5, 2.0, 0.04}, {}}};

TEST(SecondJudge, AgreesWithTheCheckerOnRandomMotionsOfATickAndMore) {
  constexpr unsigned kSeed = 3;
  test::RandomWorld random(kSeed);
  const auto robot = test::smallRobot();
  int free = 0;
  int blocked = 0;
  for (int round = 0; round < 100; ++round) {
    const auto world = random.world(random.oneOf(12));
    const Checker checker(world, robot);
    const SecondJudge dut(world, robot);
    for (int i = 0; i < 30; ++i) {
      const Motion motion = random.motion(*robot);
      const bool is_free = checker.isFree(motion, 0.0);
      ++(is_free ? free : blocked);
      ASSERT_FALSE(dut.disputes(motion, is_free)) << "seed " << kSeed << " round " << round << " case " << i;
    }
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(blocked, 300);
}

TEST(SecondJudge, DisputesWhatIsWrongByMoreThanTouching) {
  constexpr unsigned kSeed = 4;
  test::RandomWorld random(kSeed);
  const auto robot = test::smallRobot();
  constexpr double kWrong_m = 0.05;  // more than poses are apart and drift widens
  int disputed = 0;
  for (int round = 0; round < 100; ++round) {
    const auto world = random.world(4);
    const Checker checker(world, robot);
    const SecondJudge dut(world, robot);
    for (int i = 0; i < 10; ++i) {
      const Motion motion = random.motion(*robot);
      if (!dut.touches(motion, kWrong_m)) {
        ASSERT_TRUE(dut.disputes(motion, false)) << "seed " << kSeed << " round " << round << " case " << i;
      } else if (dut.touches(motion, -kWrong_m)) {
        ASSERT_TRUE(dut.disputes(motion, true)) << "seed " << kSeed << " round " << round << " case " << i;
      } else {
        continue;
      }
      ++disputed;
    }
  }
  EXPECT_GT(disputed, 500);
}

TEST(SecondJudge, TellsTouchingToTenMicrometres) {
  const SecondJudge dut(roomWith({kWall}), test::smallRobot());
  const auto ahead = [](double x) { return translate(0, Sense::kForward, {0.0, 0.0, 0.0}, x); };
  // The body ends .13 m before its middle, the wall begins at 1 m.
  EXPECT_FALSE(dut.touches(ahead(0.87 - 2e-5)));
  EXPECT_TRUE(dut.touches(ahead(0.87 + 2e-5)));
  EXPECT_FALSE(dut.disputes(ahead(0.87), true));
  EXPECT_FALSE(dut.disputes(ahead(0.87), false));
  EXPECT_TRUE(dut.disputes(ahead(0.88), true));
  EXPECT_TRUE(dut.disputes(ahead(0.86), false));
}

TEST(SecondJudge, SeesACornerThatTurnsIntoAWallAndOutAgain) {
  const SecondJudge dut(roomWith({kWall}), test::smallRobot());
  const Pose beside{0.8, 0.0, 0.0};  // .2 m from the wall: ends are free, corners reach .234 m
  EXPECT_FALSE(dut.touches(stay(0, beside)));
  EXPECT_FALSE(dut.touches(stay(0, {beside.x, beside.y, 1.5707963})));
  EXPECT_TRUE(dut.touches(turn(0, beside, 1.5707963, 1.5707963)));
}

TEST(SecondJudge, LetsWhatIsLowUnderATableAndNotWhatStandsOrGetsUp) {
  const auto robot = test::smallRobot();
  const SecondJudge dut(roomWith({kTop}), robot);
  EXPECT_FALSE(dut.touches(translate(2, Sense::kForward, {-0.5, 0.0, 0.0}, 1.0)));
  EXPECT_TRUE(dut.touches(stay(0, {0.0, 0.0, 0.0})));
  EXPECT_TRUE(dut.touches(switchModes(*robot->findSwitch(2, 0), {0.0, 0.0, 0.0})));
}

TEST(SecondJudge, KeepsTheRobotInTheBounds) {
  const SecondJudge dut(roomWith({}), test::smallRobot());
  EXPECT_FALSE(dut.touches(translate(0, Sense::kForward, {4.0, 0.0, 0.0}, 0.87)));
  EXPECT_TRUE(dut.touches(translate(0, Sense::kForward, {4.0, 0.0, 0.0}, 0.871)));
}

}  // namespace
}  // namespace underway::sim
