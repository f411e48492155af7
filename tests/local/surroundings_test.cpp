#include "local/surroundings.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
  dut_.expect(*map_, plan_);  // a new plan, made with what was seen
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

}  // namespace
}  // namespace underway
