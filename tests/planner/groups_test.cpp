#include "planner/groups.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

Robot robotOf(std::size_t modes, std::vector<Switch> switches) {
  Robot robot = *test::nao();
  robot.modes.assign(modes, robot.modes[0]);
  for (std::size_t i = 0; i < modes; ++i) robot.modes[i].name = "mode_" + std::to_string(i);
  robot.switches = std::move(switches);
  return *checkedRobot(robot);
}

using Modes = std::vector<std::vector<ModeId>>;

TEST(Groups, HoldNaosStandingModesTogetherAndItsCrawlApart) {
  const Groups dut(*test::nao());
  EXPECT_EQ(dut.modes, (Modes{{0, 1}, {2}}));
  EXPECT_EQ(dut.of_mode, (std::vector<GroupId>{0, 0, 1}));
}

TEST(Groups, JoinWhatChangesOnTheSpotAlsoOneWayAndOverOthers) {
  EXPECT_EQ(Groups(robotOf(3, {{0, 2, 1.0, {}, {}}, {2, 1, 0.0, {}, {}}})).modes, (Modes{{0, 1, 2}}));
  EXPECT_EQ(Groups(robotOf(1, {})).modes, (Modes{{0}}));
  EXPECT_EQ(Groups(robotOf(3, {})).modes, (Modes{{0}, {1}, {2}}));
}

TEST(Groups, KeepApartWhatTheSwitchMovesAndWhatCannotTurn) {
  EXPECT_EQ(Groups(robotOf(2, {{0, 1, 1.0, {0.1, 0, 0}, {}}, {1, 0, 1.0, {0, 0, 0.1}, {}}})).modes,
            (Modes{{0}, {1}}));
  Robot robot = robotOf(2, {{0, 1, 1.0, {}, {}}, {1, 0, 1.0, {}, {}}});
  robot.modes[1].turn_speed_radps = 0.0;
  EXPECT_EQ(Groups(robot).modes, (Modes{{0}, {1}}));
}

TEST(Groups, OfRandomRobotsHoldEveryModeOnceAndAreNumberedByTheirFirst) {
  constexpr unsigned kSeed = 1;
  test::RandomWorld random(kSeed);
  for (int round = 0; round < 500; ++round) {
    const auto count = static_cast<std::size_t>(1 + random.oneOf(5));
    std::vector<Switch> switches;
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b)
        if (a != b && random.oneOf(4) == 0)
          switches.push_back({static_cast<ModeId>(a),
                              static_cast<ModeId>(b),
                              1.0,
                              random.oneOf(2) == 0 ? Pose{} : Pose{0.1, 0, 0},
                              {}});
    const Groups dut(robotOf(count, switches));
    std::multiset<ModeId> held;
    for (std::size_t g = 0; g < dut.modes.size(); ++g) {
      ASSERT_TRUE(std::is_sorted(dut.modes[g].begin(), dut.modes[g].end()));
      if (g > 0) {
        ASSERT_LT(dut.modes[g - 1].front(), dut.modes[g].front()) << "seed " << kSeed << " round " << round;
      }
      for (const ModeId mode : dut.modes[g]) {
        ASSERT_EQ(dut.of_mode[mode], g);
        held.insert(mode);
      }
    }
    ASSERT_EQ(held.size(), count);
    for (const Switch& change : switches) {
      if (change.displacement == Pose{}) {
        ASSERT_EQ(dut.of_mode[change.from], dut.of_mode[change.to]) << "seed " << kSeed << " round " << round;
      }
    }
  }
}

}  // namespace
}  // namespace underway
