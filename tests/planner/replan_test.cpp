#include "planner/replan.hpp"

#include <gtest/gtest.h>

#include <functional>

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

TEST_F(Executed, HasARemainderThatIsToldAnewAndPassesItsCertificate) {
  const Executing executing = at(longest(), 0.25);
  planner_.update(std::make_shared<const World>(
      *planner_.checker()->world().added({"box", {{5.4, 0.4, 0.2}, {0.2, 0.2, 0.4}, {}}})));
  const auto dut = remaining(executing, *planner_.checker());
  ASSERT_TRUE(dut.has_value()) << dut.error().message;
  EXPECT_EQ(dut->revision, planner_.checker()->world().revision());
  EXPECT_TRUE(certify(*dut, from(executing), *planner_.checker()).empty());
}

TEST_F(Executed, IsStaleWithTheSegmentAndWhatBlocksIt) {
  const std::size_t blocked = longest();
  planner_.update(withBoxOn(plan_.segments[blocked].motion));
  const auto dut = remaining(at(0, 0.0), *planner_.checker());
  ASSERT_FALSE(dut.has_value());
  EXPECT_EQ(dut.error().code, ErrorCode::kStaleRevision);
  EXPECT_EQ(dut.error().message,
            "segment " + std::to_string(blocked + 1) + " of the plan is blocked now by box");
  EXPECT_EQ(dut.error().revision, planner_.checker()->world().revision());
}

TEST_F(Executed, IsNotStaleForWhatLiesBehindTheRobot) {
  const std::size_t blocked = longest();
  const Motion& motion = plan_.segments[blocked].motion;
  planner_.update(std::make_shared<const World>(*planner_.checker()->world().added(
      {"box", {{motion.from.x - 0.4, motion.from.y, 0.2}, {0.2, 0.2, 0.4}, {}}})));
  EXPECT_TRUE(remaining(at(blocked, 0.9), *planner_.checker()).has_value());
}

TEST_F(Executed, IsNoPlanWhenItsMotionsCannotBeDone) {
  const auto messageOf = [&](const std::function<void(Executing&)>& spoil) {
    Executing executing = at(0, 0.0);
    spoil(executing);
    const auto dut = remaining(executing, *planner_.checker());
    EXPECT_FALSE(dut.has_value());
    EXPECT_EQ(dut.error().code, ErrorCode::kInvalidRequest);
    return dut.error().message;
  };
  EXPECT_NE(messageOf([](Executing& e) {
              e.plan.segments[0].motion = {MotionKind::kSwitch, 2, 1, Sense::kForward, {}, {}, 0.0};
            }).find("cannot do segment 1"),
            std::string::npos);
  EXPECT_NE(messageOf([](Executing& e) { e.done = 1.5; }).find("no share"), std::string::npos);
  EXPECT_NE(messageOf([](Executing& e) { e.segment = 99; }).find("segment 100 is not one of them"),
            std::string::npos);
  EXPECT_NE(messageOf([&](Executing& e) {
              e.plan.segments[longest()].motion.from.x += 1e-6;
            }).find("what is being followed is no plan"),
            std::string::npos);
}

TEST_F(Executed, IsLeftWhenItLeadsToNoneOfTheGoals) {
  Request request = from(at(0, 0.0));
  request.goal.y += 0.5;
  const auto dut = replan(planner_, at(0, 0.0), request, soon());
  ASSERT_TRUE(dut.has_value()) << dut.error().message;
  EXPECT_TRUE(dut->is_new);
  request.other_goals = {{kRight.position(), kRight.yaw}};
  request.goal.y = kRight.y + 0.001;
  request.goal_yaw = 1.0;
  const auto kept = replan(planner_, at(0, 0.0), request, soon());
  ASSERT_TRUE(kept.has_value());
  EXPECT_FALSE(kept->is_new) << kept->why;
  EXPECT_EQ(kept->plan.goal_index, 1U);
}

/// A plan that crawls under a table, in the middle of its switches.
TEST(ExecutedCrawl, IsKeptWhileNothingChangesAlsoInTheMiddleOfASwitch) {
  Planner planner(test::ourWorld("scenario3"), test::nao());
  Request request = requestFor({0.6, 2.0, 0.0}, {5.4, 2.0, 0.0}, Policy::kFastest);
  const Plan plan = planner.plan(request, soon()).value();
  std::size_t switches = 0;
  for (std::size_t i = 0; i < plan.segments.size(); ++i) {
    const Executing executing{plan, i, 0.5};
    const Onward next = onward(executing, *test::nao());
    request.start = next.start;
    request.start_mode = next.mode;
    const auto dut = replan(planner, executing, request, soon());
    ASSERT_TRUE(dut.has_value()) << dut.error().message;
    EXPECT_FALSE(dut->is_new) << "segment " << i << ": " << dut->why;
    switches += plan.segments[i].motion.kind == MotionKind::kSwitch ? 1 : 0;
  }
  EXPECT_GE(switches, 2U);
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
