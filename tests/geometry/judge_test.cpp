#include "geometry/judge.hpp"

#include <gtest/gtest.h>

#include "bench/random_geometry.hpp"
#include "bench/reference.hpp"
#include "geometry/checker.hpp"
#include "tests/geometry/random_world.hpp"

// The second opinion against the first, which shares no code with it, and against the slow reference.
namespace underway {
namespace {

// What either may be off by: the clearance told is up to 1 um below the truth, and the judge takes off 1 um
// and, within 1 m, is up to 20 um too kind at corners: FCL's cylinders touch by iteration. In turns he takes
// off 0.1 mm.
constexpr double kSlack_m = 2e-5;
constexpr double kFurthest_m = 1.0;  // that clearances are told to
constexpr double kTurnSlack_m = 1.3e-4;

std::shared_ptr<const World> worldOf(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(
      *World::make("random", {{-50, -50, 0}, 100, 100}, 0.0, std::move(obstacles)));
}

double slackOf(const Motion& motion) { return motion.kind == MotionKind::kTurn ? kTurnSlack_m : kSlack_m; }

/// That the judge grants the clearance that the checker tells, and not a hair more.
void expectAgreement(const Checker& checker, const Motion& motion) {
  const double told = checker.closeness(motion, 0.5).clearance_m;
  if (told > 0.0) {
    ASSERT_TRUE(checker.judge().isClear(motion, told)) << "told " << told;
    ASSERT_TRUE(checker.judge().isClear(motion, 0.5 * told)) << "told " << told;
  }
  if (told < 0.5) {
    ASSERT_FALSE(checker.judge().isClear(motion, told + slackOf(motion))) << "told " << told;
  }
}

TEST(Judge, GrantsTheClearanceThatIsToldAndNotAHairMore) {
  constexpr unsigned kSeed = 1;
  test::RandomWorld random(kSeed);
  const auto robot = bench::benchRobot();
  for (int round = 0; round < 150; ++round) {
    const Checker checker(random.world(random.oneOf(10)), robot);
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round << " case " << i);
      expectAgreement(checker, random.motion(*robot));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Judge, GrantsItToWhatIsThinTinyHugeOrTilted) {
  constexpr unsigned kSeed = 2;
  bench::RandomGeometry random(kSeed);
  const auto robot = bench::benchRobot();
  for (int round = 0; round < 1500; ++round) {
    const Checker checker(worldOf(random.obstacles({0, 0}, 1 + random.oneOf(4))), robot);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    expectAgreement(checker, random.motion({0, 0}, *robot));
    if (HasFatalFailure()) return;
  }
}

TEST(Judge, SeesWhatChangesOfTheWorldBroughtAndTook) {
  constexpr unsigned kSeed = 3;
  test::RandomWorld random(kSeed);
  const auto robot = bench::benchRobot();
  auto world = random.world(8);
  Checker checker(world, robot);
  for (int round = 0; round < 200; ++round) {
    const auto i = static_cast<std::size_t>(random.oneOf(static_cast<int>(world->obstacles().size())));
    const std::string id = world->obstacles()[i].id;
    auto changed = random.oneOf(3) == 0 ? world->moved(id, random.box(true))
                   : random.oneOf(2) == 0 && world->obstacles().size() > 4
                       ? world->removed(id)
                       : world->added({"new_" + std::to_string(round), random.box(true)});
    ASSERT_TRUE(changed);
    world = std::make_shared<const World>(std::move(*changed));
    checker = checker.at(world);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    for (int k = 0; k < 5; ++k) expectAgreement(checker, random.motion(*robot));
    if (HasFatalFailure()) return;
  }
}

TEST(Judge, ComesWithinExactlyWhatTheReferenceMeasures) {
  constexpr unsigned kSeed = 4;
  bench::RandomGeometry random(kSeed);
  int near = 0;
  for (int round = 0; round < 4000; ++round) {
    const OrientedBox box = random.box({0, 0});
    const Range slab{0.005, random.between(0.1, 0.8)};
    const Prism body{random.pose({0, 0}), {-0.15, 0.25}, {-0.2, 0.2}, slab};
    const auto shadow = bench::reference::shadow(box, slab);
    const FclShapes dut({std::make_shared<const Obstacle>(Obstacle{"box", box})});
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    if (shadow.size() < 3) continue;  // seen on edge or not at all: which, is a matter of nanometres
    const auto footprint = body.footprint();
    const double apart = bench::reference::distance({footprint.begin(), footprint.end()}, shadow);
    if (apart > kFurthest_m) continue;
    ASSERT_TRUE(dut.comeWithin(body, apart + kSlack_m)) << apart;
    if (apart > kSlack_m) {
      ASSERT_FALSE(dut.comeWithin(body, apart - kSlack_m)) << apart;
      ++near;
    }
  }
  EXPECT_GT(near, 500);
}

TEST(Judge, FindsNothingInAWorldWithoutObstacles) {
  const Checker checker(worldOf({}), bench::benchRobot());
  EXPECT_TRUE(checker.judge().isClear(turn(0, {0, 0, 0}, 6.0, 6.0), 1.0));
  EXPECT_TRUE(checker.judge().isClear(translate(2, Sense::kForward, {0, 0, 0}, 3.0), 1.0));
}

}  // namespace
}  // namespace underway
