#include "geometry/checker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "geometry/flatten.hpp"
#include "geometry/judge.hpp"
#include "geometry/sweep.hpp"
#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

constexpr int kCases = 3000;

/// The slow and obvious way: the body at poses 1 mm or 0.2 degrees apart, each against every obstacle.
struct Sampled {
  double clearance_m;
  bool inside;
};

Sampled sampled(const World& world, const Robot& robot, const Motion& motion) {
  Sampled result{1e9, true};
  std::vector<std::vector<Point>> pieces;
  const double way = length(motion);
  const int steps = 1 + static_cast<int>(std::max(way / 1e-3, std::abs(motion.angle_rad) / 3.49e-3));
  for (int k = 0; k <= steps; ++k) {
    Motion at = motion;
    if (motion.kind == MotionKind::kTranslate) {
      // The body where it is by then, as wide as the whole sweep.
      at = translate(motion.mode, motion.sense, motion.from, way * k / steps);
    } else if (motion.kind == MotionKind::kTurn) {
      at = stay(motion.mode, {motion.from.x, motion.from.y, motion.from.yaw + motion.angle_rad * k / steps});
    }
    Prism body = sweptBox(robot, at, world.floorZ());
    if (motion.kind == MotionKind::kTranslate) {
      const double widening = robot.modes[motion.mode].drift_m_per_m * (way - length(at));
      const bool along_x = motion.sense == Sense::kForward || motion.sense == Sense::kBackward;
      (along_x ? body.y : body.x) = (along_x ? body.y : body.x).grown(widening);
    }
    for (const Point corner : body.footprint()) result.inside &= world.bounds().contains(corner);
    if (k == 0)
      for (const Obstacle& obstacle : world.obstacles()) pieces.push_back(flattened(obstacle.box, body.z));
    for (const std::vector<Point>& piece : pieces) {
      if (!piece.empty())
        result.clearance_m = std::min(result.clearance_m, gapBetween(body.footprint(), piece).distance_m);
    }
    if (motion.kind == MotionKind::kSwitch || way + std::abs(motion.angle_rad) == 0.0) break;
  }
  return result;
}

class CheckerProperty : public ::testing::TestWithParam<unsigned> {
 protected:
  test::RandomWorld random{GetParam()};
  std::shared_ptr<const Robot> robot = test::smallRobot();
  std::shared_ptr<const World> world = random.world(12);
  Checker dut{world, robot};
};

TEST_P(CheckerProperty, FreeMeansFreeAtEverySampleAndBlockedMeansAContactNearOne) {
  for (int i = 0; i < kCases / 20; ++i) {
    const Motion motion = random.motion(*robot);
    const Sampled truth = sampled(*world, *robot, motion);
    const bool free = dut.isFree(motion, 0.0);
    if (free) {
      ASSERT_GT(truth.clearance_m, 0.0) << "case " << i;
      ASSERT_TRUE(truth.inside) << "case " << i;
    } else if (dut.isInBounds(motion)) {
      // Sampling may miss the contact by half a step's move of the furthest corner.
      ASSERT_LT(truth.clearance_m, 2.5e-3) << "case " << i;
    }
  }
}

TEST_P(CheckerProperty, ClearanceIsNeverAboveTheTruthAndAtMostAMillimetreBelow) {
  for (int i = 0; i < kCases / 20; ++i) {
    const Motion motion = random.motion(*robot);
    const Sampled truth = sampled(*world, *robot, motion);
    const Closeness told = dut.closeness(motion, 1.0);
    ASSERT_LE(told.clearance_m, std::min(1.0, truth.clearance_m) + 1e-9) << "case " << i;
    ASSERT_GE(told.clearance_m, std::min(1.0, truth.clearance_m) - 2.5e-3) << "case " << i;
    ASSERT_EQ(told.nearest.has_value(), told.clearance_m < 1.0);
  }
}

TEST_P(CheckerProperty, BooleansOfFclAndPlanarDistancesAgreeOnPosesAwayFromContact) {
  for (int i = 0; i < kCases; ++i) {
    const Motion pose = stay(static_cast<ModeId>(random.oneOf(3)), random.pose());
    const double clearance = dut.closeness(pose).clearance_m;
    if (clearance > 0.0 && clearance <= 1e-9) continue;
    ASSERT_EQ(dut.isFree(pose, 0.0), clearance > 0.0 && dut.isInBounds(pose)) << "case " << i;
  }
}

TEST_P(CheckerProperty, TheJudgeConfirmsEveryClearanceAndRejectsAMillimetreMore) {
  for (int i = 0; i < kCases / 10; ++i) {
    const Motion motion = random.motion(*robot);
    const double clearance = dut.closeness(motion).clearance_m;
    if (clearance == 0.0 || clearance >= 1.0) continue;
    ASSERT_TRUE(dut.judge().isClear(motion, clearance)) << "case " << i << ", clearance " << clearance;
    ASSERT_FALSE(dut.judge().isClear(motion, clearance + 1.5e-3))
        << "case " << i << ", clearance " << clearance;
  }
}

TEST_P(CheckerProperty, MovingAndTurningWorldAndMotionTogetherChangesNoAnswer) {
  const Pose by{random.between(-5.0, 5.0), random.between(-5.0, 5.0), random.angle()};
  const auto crowded = random.world(12, false);
  std::vector<Obstacle> obstacles(crowded->obstacles().begin(), crowded->obstacles().end());
  const auto world_here =
      std::make_shared<const World>(*World::make("here", {{-20, -20, 0}, 40, 40}, 0.0, obstacles));
  for (Obstacle& obstacle : obstacles) {
    const Pose moved =
        compose(by, {obstacle.box.center_m.x, obstacle.box.center_m.y, obstacle.box.rpy_rad.z});
    obstacle.box.center_m.x = moved.x;
    obstacle.box.center_m.y = moved.y;
    obstacle.box.rpy_rad.z = moved.yaw;
  }
  const auto world_there = std::make_shared<const World>(
      *World::make("there", {compose(by, {-20, -20, 0}), 40, 40}, 0.0, obstacles));
  const Checker here(world_here, robot);
  const Checker there(world_there, robot);
  for (int i = 0; i < kCases / 5; ++i) {
    const Motion motion = random.motion(*robot);
    Motion moved = motion;
    moved.from = compose(by, motion.from);
    moved.to = compose(by, motion.to);
    const double clearance = here.closeness(motion).clearance_m;
    ASSERT_NEAR(clearance, there.closeness(moved).clearance_m, 6e-4);
    if (clearance <= 1e-3) continue;
    ASSERT_EQ(here.isFree(motion, 0.0), there.isFree(moved, 0.0)) << "case " << i;
  }
}

TEST_P(CheckerProperty, RemovingAnObstacleNeverBlocks) {
  std::vector<Obstacle> fewer(world->obstacles().begin(), world->obstacles().end());
  fewer.resize(fewer.size() - 3);
  const Checker without(std::make_shared<const World>(*World::make("fewer", world->bounds(), 0.0, fewer)),
                        robot);
  for (int i = 0; i < kCases; ++i) {
    const Motion motion = random.motion(*robot);
    ASSERT_TRUE(!dut.isFree(motion) || without.isFree(motion)) << "case " << i;
  }
}

TEST_P(CheckerProperty, ASweepOfNoLengthIsThePose) {
  for (int i = 0; i < kCases; ++i) {
    const auto mode = static_cast<ModeId>(random.oneOf(3));
    const Pose pose = random.pose();
    const Motion sweep = translate(mode, kSenses[static_cast<std::size_t>(random.oneOf(4))], pose, 0.0);
    ASSERT_EQ(dut.isFree(sweep), dut.isFree(stay(mode, pose)));
    ASSERT_EQ(dut.closeness(sweep).clearance_m, dut.closeness(stay(mode, pose)).clearance_m);
  }
}

TEST_P(CheckerProperty, ASweepHoldsBothThatItIsMadeOf) {
  for (int i = 0; i < kCases; ++i) {
    const auto mode = static_cast<ModeId>(random.oneOf(3));
    const Pose pose = random.pose();
    const Sense sense = kSenses[static_cast<std::size_t>(random.oneOf(4))];
    const double length_m = random.between(0.0, 1.0);
    const Motion whole = translate(mode, sense, pose, length_m);
    const Motion first = translate(mode, sense, pose, random.between(0.0, 1.0) * length_m);
    const Motion second = translate(mode, sense, first.to, whole.to.position());
    if (dut.isFree(whole)) {
      ASSERT_TRUE(dut.isFree(first) && dut.isFree(second)) << "case " << i;
    }
    const double least = std::min(dut.closeness(first).clearance_m, dut.closeness(second).clearance_m);
    ASSERT_LE(dut.closeness(whole).clearance_m, least + 1e-9) << "case " << i;
  }
}

TEST_P(CheckerProperty, ClearanceIsZeroExactlyWhenAMotionTouches) {
  for (int i = 0; i < kCases; ++i) {
    const Motion motion = random.motion(*robot);
    if (!dut.isInBounds(motion)) continue;
    ASSERT_EQ(dut.closeness(motion).clearance_m == 0.0, !dut.isFree(motion, 0.0)) << "case " << i;
  }
}

TEST_P(CheckerProperty, ManyMotionsInOneCallAreAnsweredAsOneByOne) {
  std::vector<Motion> motions;
  for (int i = 0; i < kCases; ++i) motions.push_back(random.motion(*robot));
  const std::vector<char> free = dut.areFree(motions, 0.02);
  ASSERT_EQ(free.size(), motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) ASSERT_EQ(free[i] != 0, dut.isFree(motions[i], 0.02)) << i;
}

/// The same answers from one that was changed step by step as from one made anew; the first one's stay.
TEST_P(CheckerProperty, RevisionsAnswerAsCheckersMadeAnewAndDisturbNoEarlierOne) {
  std::vector<Motion> motions;
  for (int i = 0; i < 300; ++i) motions.push_back(random.motion(*robot));
  const std::vector<char> at_first = dut.areFree(motions, 0.02);
  std::jthread reader([&](const std::stop_token& stop) {  // all the while
    while (!stop.stop_requested()) {
      ASSERT_EQ(dut.areFree(motions, 0.02), at_first);
      for (int k = 0; k < 3; ++k) (void)dut.judge().isClear(motions[static_cast<std::size_t>(k)], 0.0);
    }
  });
  Checker changed = dut.at(world);
  auto revision = world;
  for (int step = 0; step < 60; ++step) {
    const auto i = static_cast<std::size_t>(random.oneOf(static_cast<int>(revision->obstacles().size())));
    const std::string id = revision->obstacles()[i].id;
    const int what = random.oneOf(3);
    auto next = what == 0 && revision->obstacles().size() > 1 ? revision->removed(id)
                : what == 1                                   ? revision->moved(id, random.box(true))
                            : revision->added({"new_" + std::to_string(step), random.box(true)});
    revision = std::make_shared<const World>(std::move(*next));
    changed = changed.at(revision);
    const Checker fresh(revision, robot);
    ASSERT_EQ(changed.areFree(motions, 0.02), fresh.areFree(motions, 0.02)) << "step " << step;
    for (const Motion& motion : motions) {
      const Closeness here = changed.closeness(motion);
      const Closeness there = fresh.closeness(motion);
      ASSERT_EQ(here.clearance_m, there.clearance_m);
      ASSERT_EQ(here.headroom_m, there.headroom_m);
      ASSERT_EQ(here.nearest.has_value(), there.nearest.has_value());
      if (here.nearest) {
        ASSERT_EQ(here.nearest->id, there.nearest->id);
      }
    }
    for (std::size_t k = 0; k < 20; ++k)
      ASSERT_EQ(changed.judge().isClear(motions[k], 0.0), fresh.judge().isClear(motions[k], 0.0));
  }
}

TEST_P(CheckerProperty, RoomToTurnAllRoundMeansEveryTurnIsFree) {
  int found = 0;
  for (int i = 0; i < kCases; ++i) {
    const Pose pose = random.pose();
    const auto mode = static_cast<ModeId>(random.oneOf(2));
    if (!dut.isFreeAllRound(mode, pose.position(), robot->margin_m)) continue;
    ++found;
    ASSERT_TRUE(dut.isFree(turn(mode, pose, 6.3, normalizedAngle(pose.yaw + 6.3))));
  }
  EXPECT_GT(found, 0);
}

TEST_P(CheckerProperty, BlockersAreThereExactlyWhenAMotionIsNotFree) {
  for (int i = 0; i < kCases / 10; ++i) {
    const Motion motion = random.motion(*robot);
    if (!dut.isInBounds(motion)) continue;
    ASSERT_EQ(dut.blockers(motion, 0.02).empty(), dut.isFree(motion, 0.02)) << "case " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CheckerProperty, ::testing::Values(1U, 2U, 3U, 4U));

/// A room of 6 x 4 m with what a test puts in it.
Checker roomWith(std::vector<Obstacle> obstacles) {
  return {std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 6, 4}, 0.0, std::move(obstacles))),
          test::smallRobot()};
}

TEST(Checker, TouchingIsACollisionAndAMillimetreAwayIsNot) {
  // The body's front is at x = 1.13; the box begins there, then a millimetre further on.
  const Motion pose = stay(0, {1.0, 1.0, 0.0});
  EXPECT_FALSE(roomWith({{"box", {{1.63, 1.0, 0.5}, {1.0, 1.0, 1.0}, {}}}}).isFree(pose, 0.0));
  const Checker dut = roomWith({{"box", {{1.631, 1.0, 0.5}, {1.0, 1.0, 1.0}, {}}}});
  EXPECT_TRUE(dut.isFree(pose, 0.0));
  EXPECT_FALSE(dut.isFree(pose, 0.02));
  EXPECT_NEAR(dut.closeness(pose).clearance_m, 0.001, 2e-9);
  EXPECT_EQ(dut.closeness(pose).nearest->id, "box");
  EXPECT_EQ(dut.blockers(pose, 0.02), std::vector<std::string>{"box"});
}

TEST(Checker, AModeSeesOnlyWhatReachesIntoItsSlab) {
  const Checker dut = roomWith({{"table", {{1.0, 1.0, 0.65}, {0.8, 0.8, 0.7}, {}}},      // from .30 m up
                                {"sill", {{3.0, 1.0, 0.002}, {0.8, 0.8, 0.005}, {}}}});  // up to 4.5 mm
  EXPECT_FALSE(dut.isFree(stay(0, {1.0, 1.0, 0.0})));
  EXPECT_TRUE(dut.isFree(stay(2, {1.0, 1.0, 0.0})));
  EXPECT_NEAR(*dut.closeness(stay(2, {1.0, 1.0, 0.0})).headroom_m, 0.09, 1e-12);
  EXPECT_FALSE(dut.closeness(stay(2, {1.8, 1.0, 0.0})).headroom_m.has_value());
  EXPECT_TRUE(dut.isFree(stay(0, {3.0, 1.0, 0.0})));
}

TEST(Checker, TheBodyMayStandOnTheEdgeOfTheBoundsButNotBeyond) {
  const Checker dut = roomWith({});
  EXPECT_TRUE(dut.isFree(stay(0, {0.13, 0.195, 0.0})));
  EXPECT_FALSE(dut.isFree(stay(0, {0.1299, 0.195, 0.0})));
  EXPECT_FALSE(dut.isInBounds(turn(0, {0.13, 0.195, 0.0}, 0.1, 0.1)));
}

TEST(Checker, DriftWidensALongCrawl) {
  // A lane .45 m wide: the crawl's .39 m and its margins leave .02 m for drift, which is a metre.
  const Checker dut = roomWith({{"left", {{3.0, 1.325, 0.5}, {6.0, 0.2, 1.0}, {}}},
                                {"right", {{3.0, 0.675, 0.5}, {6.0, 0.2, 1.0}, {}}}});
  EXPECT_TRUE(dut.isFree(translate(2, Sense::kForward, {1.0, 1.0, 0.0}, 0.49)));
  EXPECT_FALSE(dut.isFree(translate(2, Sense::kForward, {1.0, 1.0, 0.0}, 0.51)));
  EXPECT_NEAR(dut.closeness(translate(2, Sense::kForward, {1.0, 1.0, 0.0}, 0.5)).clearance_m, 0.02, 2e-9);
}

TEST(Checker, ATurnIsStoppedByAPostThatOnlyTheCornersReach) {
  // The corners pass at .2344 m from the pivot, the sides at .195 m: a post between is met on the way only.
  const Checker dut = roomWith({{"post", {{2.0, 2.225, 0.5}, {0.01, 0.01, 1.0}, {}}}});
  EXPECT_TRUE(dut.isFree(stay(0, {2.0, 2.0, 0.0}), 0.0));
  EXPECT_TRUE(dut.isFree(stay(0, {2.0, 2.0, 1.5707963267948966}), 0.0));
  EXPECT_FALSE(dut.isFree(turn(0, {2.0, 2.0, 0.0}, 1.5707963267948966, 1.5707963267948966), 0.0));
  EXPECT_TRUE(dut.isFree(turn(0, {2.0, 2.0, 0.0}, 0.2, 0.2), 0.0));
}

TEST(Checker, WhatIsNotFiniteIsNeitherFreeNorClear) {
  const Checker dut = roomWith({});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Pose& pose :
       {Pose{nan, 1, 0}, Pose{1, nan, 0}, Pose{1, 1, nan}, Pose{INFINITY, 1, 0}, Pose{1, 1, INFINITY}}) {
    EXPECT_FALSE(dut.isFree(stay(0, pose)));
    EXPECT_FALSE(dut.isFree(turn(0, pose, 1.0, 1.0)));
    EXPECT_FALSE(dut.isFree(translate(0, Sense::kForward, pose, 0.1)));
    EXPECT_EQ(dut.closeness(stay(0, pose)).clearance_m, 0.0);
    EXPECT_TRUE(dut.blockers(stay(0, pose), 0.0).empty());
  }
  EXPECT_FALSE(dut.isFree(turn(0, {3, 2, 0}, nan, 0.0)));
  EXPECT_EQ(dut.areFree(std::vector{stay(0, {nan, 1, 0}), stay(0, {3, 2, 0})}, 0.0),
            (std::vector<char>{0, 1}));
}

TEST(Checker, AnotherFloorMakesOtherSlabs) {
  const auto low = std::make_shared<const World>(
      *World::make("room", {{0, 0, 0}, 6, 4}, 0.0, {{"table", {{3.0, 2.0, 0.9}, {1.0, 1.0, 0.5}, {}}}}));
  const auto high = std::make_shared<const World>(
      *World::make("room", {{0, 0, 0}, 6, 4}, 0.5, {{"table", {{3.0, 2.0, 0.9}, {1.0, 1.0, 0.5}, {}}}}));
  const Checker dut(low, test::smallRobot());
  EXPECT_TRUE(dut.isFree(stay(0, {3.0, 2.0, 0.0})));
  EXPECT_FALSE(dut.at(high).isFree(stay(0, {3.0, 2.0, 0.0})));
}

TEST(Checker, AnEmptyWorldIsFree) {
  const Checker dut = roomWith({});
  EXPECT_TRUE(dut.isFree(stay(0, {3.0, 2.0, 1.0})));
  EXPECT_EQ(dut.closeness(stay(0, {3.0, 2.0, 1.0})).clearance_m, 1.0);
  EXPECT_TRUE(dut.isFreeAllRound(0, {3.0, 2.0}, 0.02));
}

}  // namespace
}  // namespace underway
