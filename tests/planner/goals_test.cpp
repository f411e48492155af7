#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "planner/certify.hpp"
#include "tests/planner/fixture.hpp"

/// Requests with several goals, of which the best will do.
namespace underway {
namespace {

using test::ourWorld;
using test::soon;

constexpr std::array kPolicies{Policy::kPriority, Policy::kFastest, Policy::kSafest};

Request requestFor(const Pose& start, const std::vector<Goal>& goals, Policy policy = Policy::kPriority) {
  Request request;
  request.start = start;
  request.policy = policy;
  request.max_detour = std::numeric_limits<double>::infinity();
  return withGoals(request, goals);
}

class GoalsIn : public ::testing::TestWithParam<const char*> {
 protected:
  GoalsIn() { planner.prepare(soon()); }

  [[nodiscard]] Pose anywhere() {
    const Bounds& bounds = checker->world().bounds();
    std::uniform_real_distribution<double> share(0.0, 1.0);
    return transformed(bounds.corner, {share(random) * bounds.width_m, share(random) * bounds.height_m});
  }
  [[nodiscard]] Pose freePose() {
    while (true)
      if (const Pose pose = anywhere();
          checker->isFree(stay(0, pose), 0.0) && checker->isInBounds(stay(0, pose)))
        return pose;
  }
  [[nodiscard]] std::vector<Goal> someGoals(std::size_t count) {
    std::vector<Goal> goals;
    for (std::size_t i = 0; i < count; ++i) {
      const Pose pose = i % 3 == 2 ? anywhere() : freePose();
      goals.push_back({pose.position(), {}});
      if (random() % 2 == 0) goals.back().yaw = pose.yaw;
    }
    return goals;
  }
  Pose transformed(const Pose& corner, Point at) {
    const Point point = transform(corner, at);
    return {point.x, point.y, std::uniform_real_distribution<double>(-3.1, 3.1)(random)};
  }

  std::shared_ptr<const Checker> checker = std::make_shared<const Checker>(ourWorld(GetParam()), test::nao());
  Planner planner{ourWorld(GetParam()), test::nao()};
  std::mt19937 random{4};
};

/// What a policy compares: less is better.
std::vector<double> costOf(const Plan& plan, Policy policy) {
  if (policy == Policy::kFastest) return {plan.total_time_s};
  if (policy == Policy::kSafest) return {-leastClearance(plan), plan.total_time_s};
  return {test::metresIn(plan, 2), test::metresIn(plan, 1), plan.total_time_s};
}

/// Whether one plan is as good as another, but for what shortening leaves.
bool isAsGood(const Plan& plan, const Plan& other, Policy policy) {
  const std::vector<double> a = costOf(plan, policy);
  const std::vector<double> b = costOf(other, policy);
  if (a <= b) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool is_time = i + 1 == a.size();
    const double slack = is_time ? 0.05 * b[i] + 1.0 : policy == Policy::kSafest ? 1e-3 : 0.05;
    if (a[i] > b[i] + slack) return false;
    if (a[i] < b[i] - slack) return true;
  }
  return true;
}

TEST_P(GoalsIn, TheBestOfThemIsTheBestOfTheAnswersToEachAlone) {
  for (int i = 0; i < 8; ++i) {
    for (const Policy policy : kPolicies) {
      const Request request = requestFor(freePose(), someGoals(2 + random() % 5), policy);
      std::optional<Plan> best;
      for (const Goal& goal : goalsOf(request)) {
        const auto alone = planner.findPlan(withGoals(request, {goal}), soon());
        if (alone && (!best || costOf(*alone, policy) < costOf(*best, policy))) best = *alone;
      }
      if (!best) continue;
      const auto dut = planner.findPlan(request, soon());
      ASSERT_TRUE(dut.has_value()) << dut.error().message;
      EXPECT_TRUE(certify(*dut, request, *checker).empty());
      EXPECT_TRUE(isAsGood(*dut, *best, policy))
          << "case " << i << ", " << name(policy) << ": " << dut->total_time_s << " s to goal "
          << dut->goal_index << ", where " << best->total_time_s << " s do; keeping " << leastClearance(*dut)
          << " and " << leastClearance(*best) << " m";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OurMaps, GoalsIn, ::testing::Values("scenario1", "scenario3", "flat"));

/// A room of 6 x 4 m with a closet in its upper right corner that nothing leads into.
class Goals : public ::testing::Test {
 protected:
  static std::shared_ptr<const World> room() {
    return std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 6, 4}, 0.0,
                                                      {{"left", {{4.2, 3.2, 0.5}, {0.1, 1.6, 1.0}, {}}},
                                                       {"below", {{5.1, 2.4, 0.5}, {1.9, 0.1, 1.0}, {}}}}));
  }
  [[nodiscard]] Expected<Plan> planTo(const std::vector<Goal>& goals) {
    return dut.plan(requestFor(kStart, goals), soon());
  }

  static constexpr Pose kStart{1.0, 1.0, 0.0};
  const Goal near{{2.0, 1.0}, {}};
  const Goal far{{5.0, 1.0}, 0.0};
  const Goal in_closet{{5.0, 3.2}, {}};
  const Goal also_in_closet{{5.2, 3.3}, 0.5};
  const Goal in_wall{{4.2, 3.2}, 0.0};
  const Goal outside{{9.0, 2.0}, {}};
  Planner dut{room(), test::nao()};
};

TEST_F(Goals, ThePlanSaysWhichOfThemItLeadsTo) {
  const auto first = planTo({near, far});
  ASSERT_TRUE(first.has_value()) << first.error().message;
  EXPECT_EQ(first->goal_index, 0U);
  const auto second = planTo({far, near});
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->goal_index, 1U);
  EXPECT_NEAR(distance(second->goal.position(), near.at), 0.0, 0.01);
  EXPECT_EQ(first->total_time_s, second->total_time_s);
}

TEST_F(Goals, ThoseThatCannotBeStoodAtAreNoFailureAmongOthers) {
  for (const Policy policy : kPolicies) {
    const Request request = requestFor(kStart, {in_wall, outside, far, in_wall, near}, policy);
    const auto plan = dut.plan(request, soon());
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    EXPECT_EQ(plan->goal_index, 4U) << name(policy);
    EXPECT_TRUE(certify(*plan, request, *dut.checker()).empty());
  }
}

TEST_F(Goals, ThoseThatCannotBeReachedAreNoFailureAmongOthers) {
  for (const Policy policy : kPolicies) {
    const auto plan = dut.plan(requestFor(kStart, {in_closet, far, also_in_closet}, policy), soon());
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    EXPECT_EQ(plan->goal_index, 1U) << name(policy);
  }
}

TEST_F(Goals, OfEqualOnesTheFirstIsNamed) {
  const auto plan = planTo({far, near, far, near});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->goal_index, 1U);
}

TEST_F(Goals, WhereTheRobotIsAlreadyAsksForNoMotion) {
  const auto plan = planTo({far, {kStart.position(), kStart.yaw}});
  ASSERT_TRUE(plan.has_value()) << plan.error().message;
  EXPECT_EQ(plan->goal_index, 1U);
  EXPECT_TRUE(plan->segments.empty());
}

TEST_F(Goals, MayBeInModesOfTheirOwn) {
  Goal crawling = far;
  crawling.mode = 2;
  const Request request = requestFor(kStart, {crawling, in_closet});
  const auto plan = dut.plan(request, soon());
  ASSERT_TRUE(plan.has_value()) << plan.error().message;
  EXPECT_EQ(plan->goal_index, 0U);
  EXPECT_EQ(plan->segments.back().motion.to_mode, 2);
  EXPECT_TRUE(certify(*plan, request, *dut.checker()).empty());
}

TEST_F(Goals, WhenNoneCanBeStoodAtEachIsTold) {
  const auto plan = planTo({outside, in_wall});
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().code, ErrorCode::kGoalOutOfBounds);
  EXPECT_NE(plan.error().message.find("goal 1 (9.000 m"), std::string::npos) << plan.error().message;
  EXPECT_NE(plan.error().message.find("goal 2 (4.200 m"), std::string::npos) << plan.error().message;
  ASSERT_EQ(plan.error().blocking.size(), 1U);
  EXPECT_EQ(plan.error().blocking.front().obstacle, "left");
}

TEST_F(Goals, NoPathExistsOnlyIfNoneLeadsToAnyOfThem) {
  const auto no = planTo({in_closet, in_wall, also_in_closet});
  ASSERT_FALSE(no.has_value());
  EXPECT_EQ(no.error().code, ErrorCode::kNoPathExists) << no.error().message;
  EXPECT_NE(no.error().message.find("to any of 2 goals"), std::string::npos) << no.error().message;
  EXPECT_NE(no.error().message.find("of 3 goals 1 were not tried"), std::string::npos) << no.error().message;
  EXPECT_FALSE(no.error().blocking.empty());
}

TEST_F(Goals, MayBeSixtyFourAndNoMore) {
  std::vector<Goal> goals;
  for (std::size_t i = 0; i < kMostGoals; ++i)
    goals.push_back({{0.5 + 0.4 * static_cast<double>(i % 8), 0.4 + 0.4 * static_cast<double>(i / 8)}, {}});
  for (const Policy policy : kPolicies) {
    const Request request = requestFor({5.0, 1.0, 0.0}, goals, policy);
    const auto plan = dut.plan(request, soon());
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    EXPECT_TRUE(certify(*plan, request, *dut.checker()).empty());
  }
  goals.push_back(near);
  const auto refused = planTo(goals);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidRequest);
  EXPECT_NE(refused.error().message.find("64 goals, this one has 65"), std::string::npos)
      << refused.error().message;
}

TEST_F(Goals, APlanToAGoalThatWasNotAskedForFailsItsCertificate) {
  const Request request = requestFor(kStart, {near, far});
  Plan plan = dut.plan(request, soon()).value();
  plan.goal_index = 1;
  EXPECT_FALSE(certify(plan, request, *dut.checker()).empty());
  plan.goal_index = 2;
  EXPECT_FALSE(certify(plan, request, *dut.checker()).empty());
}

}  // namespace
}  // namespace underway
