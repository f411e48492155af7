#include "server/robot/pending_plans.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

#include "tests/planner/fixture.hpp"

/// A source that answers when it is let, asked through one that never waits.
namespace underway {
namespace {

struct PendingPlansTest : testing::Test {
  std::promise<void> gate;
  std::shared_future<void> is_open = gate.get_future().share();
  std::atomic<int> asked{0};
  PlanSource dut =
      asking([this](const Request& request, const std::shared_ptr<const World>&) -> Expected<Plan> {
        ++asked;
        is_open.wait();
        Plan plan;
        plan.goal = {request.start.x, 0.0, 0.0};
        return plan;
      });

  static Request from(double x) { return test::requestFor({x, 1.0, 0.0}, {3.0, 1.0, 0.0}); }
  /// Asks until there is an answer.
  Expected<Plan> answerTo(const Request& request) {
    Expected<Plan> plan = dut(request, nullptr);
    while (!plan && plan.error().code == ErrorCode::kBusy) {
      std::this_thread::yield();
      plan = dut(request, nullptr);
    }
    return plan;
  }
};

TEST_F(PendingPlansTest, saysBusyUntilTheAnswerIsThereAndAsksOnce) {
  for (int i = 0; i < 5; ++i) EXPECT_EQ(dut(from(1.0), nullptr).error().code, ErrorCode::kBusy);
  gate.set_value();
  const auto plan = answerTo(from(1.0));
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->goal.x, 1.0);
  EXPECT_EQ(asked, 1);
}

TEST_F(PendingPlansTest, anAnswerToAnotherPlaceIsNotTaken) {
  EXPECT_FALSE(dut(from(1.0), nullptr));
  gate.set_value();
  const auto plan = answerTo(from(2.0));
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->goal.x, 2.0);
  EXPECT_EQ(asked, 2);
}

TEST_F(PendingPlansTest, anAnswerInAnotherWorldIsNotTaken) {
  EXPECT_FALSE(dut(from(1.0), nullptr));
  gate.set_value();
  const auto world = test::ourWorld("scenario3");
  Expected<Plan> plan = dut(from(1.0), world);
  for (; !plan; plan = dut(from(1.0), world)) std::this_thread::yield();
  EXPECT_EQ(asked, 2);
}

TEST_F(PendingPlansTest, everyQuestionIsAskedAnew) {
  gate.set_value();
  ASSERT_TRUE(answerTo(from(1.0)));
  ASSERT_TRUE(answerTo(from(1.0)));
  EXPECT_EQ(asked, 2);
}

TEST_F(PendingPlansTest, waitsForTheAnswerUnderWayWhenItGoes) {
  EXPECT_FALSE(dut(from(1.0), nullptr));
  std::jthread opener([this] { gate.set_value(); });
  dut = nullptr;
  EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace underway
