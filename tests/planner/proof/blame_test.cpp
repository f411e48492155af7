#include "planner/proof/blame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "bench/rooms.hpp"
#include "tests/planner/fixture.hpp"

namespace underway::proof {
namespace {

using test::nao;
using test::requestFor;

/// What is blamed when the planner is asked, or a stand-in that always says the same.
Blame blameIn(const std::shared_ptr<const World>& world, const Request& request,
              std::optional<bool> stand_in = std::nullopt) {
  const Checker checker(world, nao());
  Interrupt interrupt(test::soon(), {});
  const auto proof = proveNoPath(checker, request, interrupt);
  if (!proof) {
    ADD_FAILURE() << "not proven";
    return {};
  }
  return blame(
      checker, *proof,
      [&](const std::shared_ptr<const World>& other) {
        return stand_in.value_or(Planner(other, nao()).plan(request, test::soon()).has_value());
      },
      interrupt);
}

void expectBlames(const Blame& told, const char* obstacle, const char* mode, const char* of, double needs_m,
                  double has_m) {
  ASSERT_EQ(told.blocking.size(), 1U);
  EXPECT_EQ(told.blocking[0].obstacle, obstacle);
  EXPECT_EQ(told.blocking[0].mode, mode);
  EXPECT_EQ(told.blocking[0].of, of);
  EXPECT_NEAR(told.blocking[0].needs_m, needs_m, 1e-6);
  EXPECT_NEAR(told.blocking[0].has_m, has_m, 1e-6);
  EXPECT_TRUE(told.is_irreducible);
}

TEST(Blame, TellsWhatHangsTooLow) {
  const Blame told = blameIn(test::ourWorld("too_low"), requestFor({0.8, 1.5, 0}, {4.2, 1.5, 0}));
  expectBlames(told, "beam", "crawl", "height", 0.21, 0.19);
  EXPECT_EQ(told.sentence, "crawl needs 0.210 m of height, beam leaves 0.190 m");
}

TEST(Blame, TellsWhichTwoStandTooClose) {
  const Blame told = blameIn(test::ourWorld("too_narrow"), requestFor({0.8, 1.5, 0}, {4.2, 1.5, 0}));
  ASSERT_EQ(told.blocking.size(), 1U);
  EXPECT_EQ(told.blocking[0].of, "width");
  EXPECT_NEAR(told.blocking[0].needs_m, 0.30, 1e-6);
  EXPECT_NEAR(told.blocking[0].has_m, 0.28, 1e-6);
  for (const char* side : {"narrow_south", "narrow_north"})
    EXPECT_NE(told.sentence.find(side), std::string::npos) << told.sentence;
}

TEST(Blame, TellsThatThereIsNoRoomToLieDownOrToGetUp) {
  for (const auto& [need, length] : {std::pair{bench::Need::kRunIn, 0.85}, {bench::Need::kSwitchBox, 0.77}}) {
    const bench::Room room = bench::roomWith(need, -0.02, 1);
    const Blame told = blameIn(room.world, room.request);
    ASSERT_EQ(told.blocking.size(), 1U);
    EXPECT_EQ(told.blocking[0].of, "length");
    EXPECT_NEAR(told.blocking[0].needs_m, length, 1e-6);
    EXPECT_NEAR(told.blocking[0].has_m, length - 0.02, 1e-6);
    EXPECT_NE(told.sentence.find("table"), std::string::npos) << told.sentence;
  }
}

TEST(Blame, NamesAllThatMustGoAndNoMore) {
  const auto beamAt = [](const char* id, double x) {
    return Obstacle{id, {{x, 2.0, 0.39}, {0.3, 4.0, 0.4}, {}}};
  };
  const auto world = std::make_shared<const World>(*World::make(
      "beams", {{0, 0, 0}, 9, 4}, 0.0,
      {beamAt("first", 3.0), beamAt("second", 6.0), {"block", {{4.5, 2.0, 0.5}, {0.3, 0.3, 1.0}, {}}}}));
  const Blame told = blameIn(world, requestFor({1, 2, 0}, {8, 2, 0}));
  ASSERT_EQ(told.blocking.size(), 2U);
  EXPECT_TRUE(told.is_irreducible);
  for (const Blocking& one : told.blocking) {
    EXPECT_NE(one.obstacle, "block");
    EXPECT_NEAR(one.has_m, 0.19, 1e-9);
  }
}

TEST(Blame, DoesNotCallASetIrreducibleThatNoPlanIsKnownWithout) {
  const Blame told = blameIn(test::ourWorld("too_low"), requestFor({0.8, 1.5, 0}, {4.2, 1.5, 0}), false);
  EXPECT_FALSE(told.is_irreducible);
  ASSERT_EQ(told.blocking.size(), 1U);
  EXPECT_EQ(told.blocking[0].obstacle, "beam");
}

TEST(Blame, BlamesNoObstacleWhereThereIsNone) {
  const auto corridor =
      std::make_shared<const World>(*World::make("corridor", {{0, 0, 0}, 6, 0.45}, 0.0, {}));
  // Too narrow to turn in: it cannot come out facing the other way.
  const Blame told = blameIn(corridor, requestFor({1, 0.225, 0}, {5, 0.225, 3.1416}), true);
  EXPECT_TRUE(told.blocking.empty());
  EXPECT_FALSE(told.sentence.empty());
}

}  // namespace
}  // namespace underway::proof
