// robots/nao.yaml against what physics measures, in a short form; `underway bench physics` has all seeds.

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/physics/journey.hpp"
#include "tests/planner/fixture.hpp"
#include "tests/sim/physics/nao_simulation.hpp"

namespace underway::physics {
namespace {

constexpr std::array<std::uint64_t, 2> kSeeds{0, 19};  // the smoothest floor and the roughest

const Switch& switchOf(const Robot& robot, const char* from, const char* to) {
  for (const Switch& change : robot.switches)
    if (change.from == *robot.findMode(from) && change.to == *robot.findMode(to)) return change;
  throw std::runtime_error("no such switch");
}

void expectWithin(const Range& measured, const Range& of_file) {
  EXPECT_GE(measured.min, of_file.min);
  EXPECT_LE(measured.max, of_file.max);
}

void expectWithin(const Recording& recording, const BodyBox& of_file) {
  const BodyBox swept = sweptBox(recording);
  expectWithin(swept.x, of_file.x);
  expectWithin(swept.y, of_file.y);
  EXPECT_LE(swept.z.max, of_file.z.max);  // the floor gives way by fractions of a millimetre
}

/// Physics, between the smoothest floor and the roughest, has what the file says between its own bounds.
void expectAround(double of_file, double one, double other, double room) {
  EXPECT_GE(of_file, std::min(one, other) - room);
  EXPECT_LE(of_file, std::max(one, other) + room);
}

TEST(NaoFileInPhysics, SwitchesTakeTheRoomAndTheTimeThatTheFileSays) {
  const Robot& robot = *test::nao();
  const Switch& down = switchOf(robot, "frontal", "crawl");
  const Switch& up = switchOf(robot, "crawl", "frontal");
  std::vector<Journey> journeys;
  for (const std::uint64_t seed : kSeeds) {
    SCOPED_TRACE(seed);
    const Table table{.depth_m = 0.1};  // short, to be quick
    journeys.push_back(crawlUnder(kRobot, table, gait::cruiseGait(), conditionsOf(seed)).value());
    expectWithin(journeys.back().down, down.body_m);
    expectWithin(journeys.back().up, up.body_m);
    EXPECT_NEAR(journeys.back().down.duration_s, down.duration_s, 0.1);
    EXPECT_NEAR(journeys.back().up.duration_s, up.duration_s, 0.1);
    for (const Recording& cycle : journeys.back().crawl.recordings)
      expectWithin(cycle, robot.modes[down.to].body_m);
  }
  expectAround(down.displacement.x, journeys[0].lying_after_down.x, journeys[1].lying_after_down.x, 0.002);
  expectAround(up.displacement.x, journeys[0].standing_after_up.x, journeys[1].standing_after_up.x, 0.002);
}

}  // namespace
}  // namespace underway::physics
