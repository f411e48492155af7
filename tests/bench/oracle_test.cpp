#include "bench/oracle.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <numbers>

#include "bench/oracle/chain.hpp"
#include "geometry/map.hpp"
#include "planner/certify.hpp"

/// The oracle decides how good plans are, so it is held against optima known by hand, and its answers against
/// the certificate that every plan must pass.
namespace underway::bench {
namespace {

constexpr double kPi = std::numbers::pi;
const std::filesystem::path kData = UNDERWAY_SOURCE_DIR;

/// One mode that moves to all four sides at .1 m/s and turns at .5 rad/s.
Robot sideways() {
  Mode walk;
  walk.name = "walk";
  walk.body_m = {{-0.13, 0.13}, {-0.195, 0.195}, {0.0, 0.5}};
  walk.speed_mps = {0.1, 0.1, 0.1, 0.1};
  walk.turn_speed_radps = 0.5;
  return *checkedRobot({"sideways", 0.0, {walk}, {}, {}});
}

World emptyRoom() { return *World::make("empty", {{0.0, 0.0, 0.0}, 4.0, 3.0}, 0.0, {}); }

Obstacle wall(const char* id, double x, double y, double width, double depth) {
  return {id, OrientedBox{{x, y, 0.5}, {width, depth, 1.0}, {}}};
}

Request from(Pose start, Pose goal, Policy policy) {
  return {start, 0, goal.position(), goal.yaw, 0, policy};
}

OracleSettings quick() {
  OracleSettings settings;
  settings.cell_m = 0.05;
  settings.headings = 32;
  settings.refine.rounds = 30;
  return settings;
}

double secondsOf(const Robot& robot, const Route& route) {
  double sum = 0.0;
  for (const Motion& motion : route) sum += duration(robot, motion);
  return sum;
}

double metresIn(ModeId mode, const Route& route) {
  double sum = 0.0;
  for (const Motion& motion : route) sum += motion.mode == mode ? length(motion) : 0.0;
  return sum;
}

void expectCertified(const Checker& checker, const Request& request, const Route& route) {
  ASSERT_FALSE(route.empty());
  for (const Flaw& flaw : certify(planOf(checker, route, request), request, checker))
    ADD_FAILURE() << "segment " << flaw.segment << " " << flaw.sentence;
}

TEST(Oracle, KnowsTheOptimumInAnEmptyRoom) {
  const Checker checker(std::make_shared<World>(emptyRoom()), std::make_shared<Robot>(sideways()));
  Oracle dut(checker, quick());
  struct Known {
    const char* what;
    Pose start, goal;
    double best_s;
  };
  const Known cases[] = {
      {"straight ahead", {1.013, 1.007, 0.0}, {3.013, 1.007, 0.0}, 20.0},
      {"to the left", {1.0, 1.0, 0.0}, {1.0, 2.3, 0.0}, 13.0},
      {"askew, and a little to the side", {1.0, 1.0, 0.3}, {1.0, 1.0, 0.4}, 0.2},
      {"a short way askew along both axes", {1.0, 1.0, 0.0}, {1.1, 1.1, 0.0}, 2.0},
      {"a long way askew with two turns", {1.0, 1.0, 0.0}, {2.0, 2.0, 0.0}, kPi + 10.0 * std::numbers::sqrt2},
      {"one turn is the goal's", {1.0, 1.0, 0.0}, {2.0, 2.0, kPi / 4}, kPi / 2 + 10.0 * std::numbers::sqrt2},
  };
  for (const Known& known : cases) {
    const Request request = from(known.start, known.goal, Policy::kFastest);
    const Route route = dut.route(request);
    SCOPED_TRACE(known.what);
    expectCertified(checker, request, route);
    EXPECT_GE(secondsOf(sideways(), route), known.best_s - 1e-6);
    EXPECT_LE(secondsOf(sideways(), route), known.best_s * 1.001);
  }
}

TEST(Oracle, GoesRoundAWallOnTheShortSide) {
  // The body's half width is .195 and it keeps its heading: past the wall's end at y = 2 its middle is
  // at 2.195.
  const auto world =
      *World::make("wall", {{0.0, 0.0, 0.0}, 4.0, 3.0}, 0.0, {wall("wall", 2.0, 1.0, 0.1, 2.0)});
  const Checker checker(std::make_shared<World>(world), std::make_shared<Robot>(sideways()));
  Oracle dut(checker, quick());
  const Request request = from({1.0, 2.0, 0.0}, {3.0, 2.0, 0.0}, Policy::kFastest);
  const Route route = dut.route(request);
  expectCertified(checker, request, route);
  EXPECT_GE(secondsOf(sideways(), route), 20.0);
  EXPECT_LE(secondsOf(sideways(), route), 23.9 + 1e-3) << "up, along and down again";
}

TEST(Oracle, SaysThatThereIsNoWay) {
  const auto world =
      *World::make("wall", {{0.0, 0.0, 0.0}, 4.0, 3.0}, 0.0, {wall("wall", 2.0, 1.5, 0.1, 3.0)});
  const Checker checker(std::make_shared<World>(world), std::make_shared<Robot>(sideways()));
  EXPECT_TRUE(
      Oracle(checker, quick()).route(from({1.0, 2.0, 0.0}, {3.0, 2.0, 0.0}, Policy::kFastest)).empty());
}

class OracleInScenario3 : public testing::Test {
 protected:
  const Map map_ = *readMap(kData / "maps" / "scenario3.yaml");
  const std::shared_ptr<const Robot> robot_ =
      std::make_shared<Robot>(*readRobot(kData / "robots" / "nao.yaml"));
  const Checker checker_{std::make_shared<World>(map_.world), robot_};
};

TEST_F(OracleInScenario3, CrawlsNoFurtherThanItMust) {
  // The map says why: lying down ends at x = 3.224 at best, getting up begins at 4.60.
  OracleSettings settings = quick();
  settings.cell_m = 0.1;
  Oracle dut(checker_, settings);
  const Request request = from({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}, Policy::kPriority);
  const Route route = dut.route(request);
  expectCertified(checker_, request, route);
  EXPECT_NEAR(metresIn(2, route), 1.376, 1e-3);
  EXPECT_NEAR(metresIn(1, route), 0.0, 1e-6);
}

TEST_F(OracleInScenario3, ComesOutFromUnderTheTable) {
  Oracle dut(checker_, quick());
  Request request = from({4.0, 2.0, 0.0}, {5.4, 3.0, kPi / 2}, Policy::kPriority);
  request.start_mode = 2;
  const Route route = dut.route(request);
  expectCertified(checker_, request, route);
  EXPECT_NEAR(metresIn(2, route), 0.60, 1e-3);
}

TEST_F(OracleInScenario3, AnswersManyGoalsAsItAnswersEach) {
  OracleSettings settings = quick();
  settings.cell_m = 0.1;
  settings.refine.rounds = 4;
  Oracle dut(checker_, settings);
  const Request one = from({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}, Policy::kFastest);
  const Request other = from({0.6, 2.0, 0.0}, {2.7, 0.8, 0.0}, Policy::kFastest);
  const auto both = dut.routes({one, other});
  EXPECT_EQ(both.front(), dut.route(one));
  EXPECT_EQ(both.back(), dut.route(other));
  expectCertified(checker_, one, both.front());
  expectCertified(checker_, other, both.back());
}

TEST_F(OracleInScenario3, KnowsRobotsWhoseLowModeTurns) {
  const auto robot = std::make_shared<Robot>(*readRobot(kData / "robots" / "nao_obb_paper.yaml"));
  const Checker checker(std::make_shared<World>(map_.world), robot);
  OracleSettings settings = quick();
  settings.cell_m = 0.1;
  Oracle dut(checker, settings);
  const Request request = from({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}, Policy::kPriority);
  const Route route = dut.route(request);
  expectCertified(checker, request, route);
  // Both boxes have the same middle: it crawls the table's depth, a box's length and the margins.
  EXPECT_GE(metresIn(2, route), 1.04 - 1e-3);
  EXPECT_LE(metresIn(2, route), 1.04 * 1.01);
}

TEST(Oracle, StoopsUnderABeam) {
  const auto robot = std::make_shared<Robot>(*readRobot(kData / "robots" / "tall_biped.yaml"));
  const Obstacle beam{"beam", OrientedBox{{3.0, 1.5, 1.1}, {0.2, 3.0, 0.3}, {}}};
  const auto world = *World::make("beam", {{0.0, 0.0, 0.0}, 6.0, 3.0}, 0.0, {beam});
  const Checker checker(std::make_shared<World>(world), robot);
  OracleSettings settings = quick();
  settings.cell_m = 0.1;
  Oracle dut(checker, settings);
  const Request request = from({1.0, 1.5, 0.0}, {5.0, 1.5, 0.0}, Policy::kPriority);
  const Route route = dut.route(request);
  expectCertified(checker, request, route);
  // It stoops and rises beside the beam, .30 m and the margin of .04 from it, and turns in between: turns
  // cost no metres.
  EXPECT_GE(metresIn(1, route), 0.88 - 1e-3);
  EXPECT_LE(metresIn(1, route), 0.88 * 1.03);
}

TEST(OracleHeadings, AreNearlyUniformAndTurnIntoEachOtherByRightAngles) {
  for (const int count : {32, 64}) {
    const auto dut = latticeHeadings(count);
    ASSERT_EQ(dut.size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      const Heading& heading = dut[static_cast<std::size_t>(i)];
      const Heading& square = dut[static_cast<std::size_t>((i + count / 4) % count)];
      EXPECT_NEAR(normalizedAngle(heading.yaw - 2.0 * kPi * i / count), 0.0, 2.0 * kPi / count / 3.0 + 1e-9);
      EXPECT_EQ(square.x, -heading.y);
      EXPECT_EQ(square.y, heading.x);
    }
  }
}

TEST(OracleGaits, AreTheModesThatChangeIntoEachOtherAtOnce) {
  const Robot robot = *readRobot(kData / "robots" / "nao.yaml");
  const Gaits dut = gaitsOf(robot, Policy::kFastest);
  ASSERT_EQ(dut.all.size(), 2U);
  EXPECT_EQ(dut.all[0].modes, (std::vector<ModeId>{0, 1}));
  EXPECT_TRUE(dut.all[0].movesToAllSides());
  EXPECT_FALSE(dut.all[1].turning.has_value());
}

}  // namespace
}  // namespace underway::bench
