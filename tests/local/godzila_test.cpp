#include "local/godzila/godzila.hpp"

#include <gtest/gtest.h>

#include "bench/local_run.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using bench::drivePurely;
using bench::PureRoom;

PureRoom arena(const std::string& name) {
  const auto map = readMap(UNDERWAY_SOURCE_DIR "/maps/" + name + ".yaml");
  return {std::make_shared<const World>(map->world), map->queries.front().start, map->queries.front().goal};
}

TEST(Godzila, PassesTheThesisArenasByItself) {
  for (const std::string name : {"arena_open", "arena_gap", "arena_corridor"})
    for (std::uint64_t seed = 1001; seed <= 1002; ++seed) {
      const auto run = drivePurely(arena(name), test::nao(), {}, seed, 1200.0);
      EXPECT_TRUE(run.has_arrived) << name << ", seed " << seed;
      EXPECT_FALSE(run.has_collided) << name << ", seed " << seed;
      EXPECT_FALSE(run.is_disputed) << name << ", seed " << seed;
    }
}

TEST(Godzila, GetsOutOfTrapsAndCollidesNowhere) {
  PureSettings keeping;
  keeping.keeps_traps = true;
  for (std::uint64_t seed = 1001; seed <= 1003; ++seed)
    for (const PureRoom& room : {bench::randomGap(seed), bench::wallInFront(seed), bench::uInFront(seed)}) {
      const auto run = drivePurely(room, test::nao(), keeping, seed, 3600.0);
      EXPECT_TRUE(run.has_arrived) << "seed " << seed;
      EXPECT_FALSE(run.has_collided) << "seed " << seed;
      EXPECT_FALSE(run.is_disputed) << "seed " << seed;
    }
}

TEST(Godzila, IsTrappedInAUWithoutItsEscape) {
  // What the escape is for: the same rooms, and a detector that never speaks.
  PureSettings without;
  without.trap.least_m = 0.0;
  int arrived = 0;
  for (std::uint64_t seed = 1001; seed <= 1006; ++seed)
    arrived += drivePurely(bench::uInFront(seed), test::nao(), without, seed, 900.0).has_arrived ? 1 : 0;
  EXPECT_LT(arrived, 5);
}

TEST(Godzila, StandsAtItsGoal) {
  Godzila dut({}, test::nao()->modes.front().body_m, standingLimits(*test::nao()), Beams{});
  Scan scan;
  scan.ranges_m.assign(scan.beams.count, Scan::kNothing);
  const auto drive = dut.tick(scan, {0.29, 1.0});
  EXPECT_EQ(drive.state, Godzila::State::kArrived);
  EXPECT_EQ(drive.velocity, Velocity{});
}

}  // namespace
}  // namespace underway
