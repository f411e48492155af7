#include "planner/proof/relaxation.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "bench/rooms.hpp"
#include "planner/proof/proof.hpp"
#include "planner/proof/way.hpp"
#include "tests/geometry/random_world.hpp"
#include "tests/planner/fixture.hpp"

// What a relaxation says of a cell holds at every pose of it, as the checker sees it.
namespace underway::proof {
namespace {

class Sampler {
 public:
  Sampler(const Checker& checker, const Relaxation& relaxation, unsigned seed)
      : checker_(checker),
        relaxation_(relaxation),
        grid_(gridOver(checker.world().bounds(), relaxation.stances().shapes)),
        random_(seed) {}

  /// A pose of a cell, in the map frame; often on the cell's edge.
  Pose poseIn(const Relaxation::Place& place) {
    const auto extent = grid_.extentOf(relaxation_.cells(place.stance).box(place.cell));
    const auto within = [&](double middle, double half) {
      const int where = random_.oneOf(4);
      return middle + half * (where == 0 ? -1.0 : where == 1 ? 1.0 : random_.between(-1.0, 1.0));
    };
    return compose(grid_.corner, {within(extent.middle.x, extent.x_m), within(extent.middle.y, extent.y_m),
                                  within(extent.middle.yaw, extent.yaw_rad)});
  }

  void expectHolds(const Outlook& outlook, const Motion& motion) {
    const double margin = checker_.robot().margin_m;
    switch (outlook.state) {
      case Outlook::State::kBlocked:
        // Under any reading of the margin: all that is nearer than it, however the corners are measured.
        EXPECT_LT(checker_.closeness(motion).clearance_m, margin + 1e-6);
        ++blocked;
        return;
      case Outlook::State::kOutside:
        EXPECT_FALSE(checker_.isInBounds(motion));
        ++outside;
        return;
      case Outlook::State::kFree:
        EXPECT_TRUE(checker_.isFree(motion, margin - 1e-6));
        ++free;
        return;
      case Outlook::State::kUndecided:
        return;
    }
  }

  void expectAllHold() {
    const Robot& robot = checker_.robot();
    for (std::uint32_t s = 0; s < relaxation_.stances().all.size(); ++s) {
      const Stance& stance = relaxation_.stances().all[s];
      for (CellId cell = 0; cell < relaxation_.cells(s).size(); ++cell) {
        const Relaxation::Place place{s, cell};
        expectHolds(relaxation_.ofBody(place), stay(stance.modes[0], poseIn(place)));
        for (std::size_t exit = 0; exit < stance.exits.size(); ++exit)
          expectHolds(relaxation_.ofExit(place, exit),
                      switchModes(robot.switches[stance.exits[exit].of_switch], poseIn(place)));
      }
    }
  }

  int blocked = 0, outside = 0, free = 0;

 private:
  const Checker& checker_;
  const Relaxation& relaxation_;
  Grid grid_;
  test::RandomWorld random_;
};

TEST(Relaxation, SaysOnlyWhatHoldsAtEveryPoseOfACell) {
  int blocked = 0, outside = 0, free = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const bench::Room room =
        seed % 3 == 0 ? bench::clutteredRoom(seed) : bench::roomWith(bench::kNeeds[seed % 5], 0.0, seed);
    const Checker checker(room.world, test::nao());
    Interrupt interrupt(test::soon(), {});
    Relaxation dut(checker, room.request, checker.robot().margin_m, interrupt);
    (void)closes(dut, 3000, interrupt);
    Sampler sampler(checker, dut, seed);
    sampler.expectAllHold();
    blocked += sampler.blocked, outside += sampler.outside, free += sampler.free;
  }
  EXPECT_GT(blocked, 3000);
  EXPECT_GT(outside, 300);
  EXPECT_GT(free, 3000);
}

/// Finds the cells that a plan passes.
class PlanTracer {
 public:
  PlanTracer(const Plan& plan, const Checker& checker, const Relaxation& relaxation)
      : plan_(plan),
        relaxation_(relaxation),
        grid_(gridOver(checker.world().bounds(), relaxation.stances().shapes)) {}

  /// All within a distance of some poses of it, evenly taken; some more than once.
  [[nodiscard]] std::vector<Relaxation::Place> places(int samples, double within_m) const {
    std::vector<Relaxation::Place> found;
    for (const auto& [motion, duration_s, closeness] : plan_.segments) {
      const int count = motion.kind == MotionKind::kSwitch ? 0 : samples;  // a switch is not on its way
      for (int i = 0; i <= count; ++i) {
        const double t = count == 0 ? 0.0 : static_cast<double>(i) / count;
        add(motion.mode,
            {motion.from.x + t * (motion.to.x - motion.from.x),
             motion.from.y + t * (motion.to.y - motion.from.y), motion.from.yaw + t * motion.angle_rad},
            within_m, found);
      }
      add(motion.to_mode, motion.to, within_m, found);
    }
    return found;
  }

 private:
  void add(ModeId mode, const Pose& map, double within_m, std::vector<Relaxation::Place>& found) const {
    const std::uint32_t stance = relaxation_.stances().of_mode[mode];
    const Pose pose = grid_.inCorner(map);
    const auto near = [&](double value) { return Range{value, value}.grown(within_m); };
    std::vector<CellId> cells;
    relaxation_.cells(stance).findTouching(grid_.boxAround(near(pose.x), near(pose.y), near(pose.yaw)),
                                           cells);
    for (const CellId cell : cells) found.push_back({stance, cell});
  }

  const Plan& plan_;
  const Relaxation& relaxation_;
  Grid grid_;
};

TEST(Relaxation, LeavesTheWayOfAPlanOpenHoweverSmallItsCellsAre) {
  test::RandomWorld random(7);
  int plans = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const bench::Room room =
        seed % 4 == 0 ? bench::clutteredRoom(seed) : bench::roomWith(bench::kNeeds[seed % 5], 0.02, seed);
    Planner planner(room.world, test::nao());
    const auto plan = planner.plan(room.request, Planner::Clock::now() + std::chrono::milliseconds(500));
    if (!plan) continue;
    ++plans;
    Interrupt interrupt(test::soon(), {});
    Relaxation dut(*planner.checker(), room.request, leastMargin(*planner.checker(), room.request, interrupt),
                   interrupt);
    const PlanTracer tracer(*plan, *planner.checker(), dut);
    for (int round = 0; round < 18; ++round)
      for (const Relaxation::Place& place : tracer.places(30, 0.0))
        if (const auto axis = static_cast<std::size_t>(random.oneOf(3)); dut.canSplit(place, axis))
          dut.split(place, axis, interrupt);
    Way cells;
    for (const Relaxation::Place& place : tracer.places(1000, 2e-3))
      cells.steps.push_back({place, std::nullopt});
    WaySearch search;
    search.confineTo(dut, cells);
    EXPECT_TRUE(search.throughOpenCells(dut, interrupt)) << "seed " << seed;
  }
  EXPECT_GT(plans, 8);
}

TEST(Relaxation, ForgetsALiftedObstacleAsIfItHadNeverBeenThere) {
  const auto world = test::ourWorld("too_low");
  const Checker checker(world, test::nao());
  const Request request = test::requestFor({0.8, 1.5, 0}, {4.2, 1.5, 0});
  Interrupt interrupt(test::soon(), {});
  const auto proof = proveNoPath(checker, request, interrupt);
  ASSERT_TRUE(proof);
  Relaxation dut = proof->relaxation;
  dut.lift(std::vector{*world->obstacles().find("beam")}, std::nullopt, interrupt);
  EXPECT_FALSE(closes(dut, 100'000, interrupt));
  const Checker without(std::make_shared<const World>(*world->removed("beam")), test::nao());
  Sampler(without, dut, 1).expectAllHold();
}

TEST(Relaxation, ModesOfOneBodyShareAStance) {
  const Checker nao(test::ourWorld("too_low"), test::nao());
  const Stances dut = stancesOf(nao, 0.02);
  ASSERT_EQ(dut.all.size(), 2U);
  EXPECT_EQ(dut.of_mode, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(dut.all[0].senses.size(), 4U);
  EXPECT_EQ(dut.all[1].senses.size(), 1U);
  EXPECT_FALSE(dut.all[1].can_turn);
}

}  // namespace
}  // namespace underway::proof
