#include "planner/replan.hpp"

#include <gtest/gtest.h>

#include "planner/certify.hpp"
#include "planner/stale.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

using test::requestFor;
using test::soon;

const Obstacle kWall{"wall", {{3.0, 2.0, 0.5}, {0.2, 2.6, 1.0}, {}}};  // a way round either end
const Pose kLeft{1.0, 2.1, 0.0};
const Pose kRight{5.0, 2.1, 0.0};

std::shared_ptr<const World> roomWith(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 6, 4}, 0.0, std::move(obstacles)));
}

/// The plan that is being executed in these tests: round the upper end of the wall, by policy fastest.
class Executed : public ::testing::Test {
 protected:
  Executed() { plan_ = *planner_.plan(request_, soon()); }

  [[nodiscard]] Executing at(std::size_t segment, double done) const { return {plan_, segment, done}; }
  [[nodiscard]] Request from(const Executing& executing) const {
    Request request = request_;
    request.start = rest(executing, *test::nao()).segments.front().motion.from;
    request.start_mode = executing.plan.segments[executing.segment].motion.mode;
    return request;
  }
  [[nodiscard]] std::size_t longest() const {
    std::size_t longest = 0;
    for (std::size_t i = 0; i < plan_.segments.size(); ++i)
      if (plan_.segments[i].duration_s > plan_.segments[longest].duration_s &&
          plan_.segments[i].motion.kind == MotionKind::kTranslate)
        longest = i;
    return longest;
  }
  [[nodiscard]] std::shared_ptr<const World> withBoxOn(const Motion& motion) const {
    const Point middle{0.5 * (motion.from.x + motion.to.x), 0.5 * (motion.from.y + motion.to.y)};
    return std::make_shared<const World>(
        *planner_.checker()->world().added({"box", {{middle.x, middle.y, 0.2}, {0.2, 0.2, 0.4}, {}}}));
  }

  Planner planner_{roomWith({kWall}), test::nao()};
  Request request_ = requestFor(kLeft, kRight, Policy::kFastest);
  Plan plan_;
};

TEST_F(Executed, IsNotBrokenByWhatIsNotOnItsWay) {
  EXPECT_FALSE(firstBroken(plan_, *planner_.checker()));
  planner_.update(std::make_shared<const World>(
      *planner_.checker()->world().added({"box", {{0.4, 0.4, 0.2}, {0.2, 0.2, 0.4}, {}}})));
  EXPECT_FALSE(firstBroken(plan_, *planner_.checker()));
}

TEST_F(Executed, IsBrokenAtTheSegmentThatIsBlockedAndNotWhenThatIsDone) {
  const std::size_t blocked = longest();
  planner_.update(withBoxOn(plan_.segments[blocked].motion));
  EXPECT_EQ(firstBroken(plan_, *planner_.checker()), blocked);
  EXPECT_FALSE(firstBroken(plan_, *planner_.checker(), blocked + 1));
}

TEST_F(Executed, IsKeptWhileNothingChanges) {
  for (std::size_t segment = 0; segment < plan_.segments.size(); ++segment) {
    const Executing executing = at(segment, 0.5);
    const auto dut = replan(planner_, executing, from(executing), soon());
    ASSERT_TRUE(dut.has_value()) << dut.error().message;
    EXPECT_FALSE(dut->is_new) << dut->why;
  }
}

TEST_F(Executed, IsLeftForAWayRoundWhatHasComeOntoIt) {
  const std::size_t blocked = longest();
  planner_.update(withBoxOn(plan_.segments[blocked].motion));
  const Executing executing = at(0, 0.0);
  const auto dut = replan(planner_, executing, from(executing), soon());
  ASSERT_TRUE(dut.has_value()) << dut.error().message;
  EXPECT_TRUE(dut->is_new);
  EXPECT_EQ(dut->plan.revision, planner_.checker()->world().revision());
  EXPECT_TRUE(certify(dut->plan, from(executing), *planner_.checker()).empty());
}

TEST_F(Executed, IsLeftOnlyForAPlanThatIsBetterByTheMargin) {
  planner_.update(roomWith({}));  // straight on is open now
  const Executing executing = at(0, 0.0);
  const auto eager = replan(planner_, executing, from(executing), soon());
  ASSERT_TRUE(eager.has_value());
  EXPECT_TRUE(eager->is_new) << eager->why;
  const auto reluctant = replan(planner_, executing, from(executing), soon(), {0.9, 2.0, 0.05, 0.005});
  ASSERT_TRUE(reluctant.has_value());
  EXPECT_FALSE(reluctant->is_new) << reluctant->why;
}

TEST_F(Executed, HasARestThatTakesWhatIsLeft) {
  const Plan half = rest(at(longest(), 0.25), *test::nao());
  double left_s = 0.75 * plan_.segments[longest()].duration_s;
  for (std::size_t i = longest() + 1; i < plan_.segments.size(); ++i) left_s += plan_.segments[i].duration_s;
  EXPECT_NEAR(half.total_time_s, left_s, 1e-9);
}

TEST_F(Executed, HasNoSegmentBeyondItsLast) {
  const auto dut = replan(planner_, at(plan_.segments.size() + 1, 0.0), request_, soon());
  ASSERT_FALSE(dut.has_value());
  EXPECT_EQ(dut.error().code, ErrorCode::kInvalidRequest);
}

}  // namespace
}  // namespace underway
