#include "server/plan_workers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <latch>
#include <map>
#include <mutex>
#include <stdexcept>

#include "tests/server/plan_fixture.hpp"

namespace underway {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPlan = -1;

/// Keeps what was finished, by the request's number: the code, or kPlan.
struct Finished {
  std::mutex mutex;
  std::multimap<std::uint64_t, int> codes;
  PlanWorkers::Finish keep() {
    return [this](const Job& job, const Expected<Given>& plan) {
      const std::scoped_lock lock(mutex);
      codes.emplace(job.id.sequence, plan ? kPlan : static_cast<int>(plan.error().code));
    };
  }
};

Job job(std::uint64_t number, Clock::time_point deadline = Clock::time_point::max()) {
  return {{{}, number}, "nao_1", {}, deadline};
}

Expected<Given> plan(const Asked&, Clock::time_point, const std::stop_token&) { return Plan{}; }

TEST(PlanWorkers, aJobWhoseDeadlineHasPassedIsNotPlanned) {
  std::atomic<int> calls = 0;
  std::promise<Expected<Given>> finished;
  PlanWorkers dut(
      [&](auto&&...) -> Expected<Given> {
        ++calls;
        return Plan{};
      },
      [&](const Job&, Expected<Given> answer) { finished.set_value(std::move(answer)); }, 1, 1);
  ASSERT_TRUE(dut.offer(job(1, Clock::now() - std::chrono::milliseconds(1))));
  const Expected<Given> answer = finished.get_future().get();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, ErrorCode::kTimeout);
  EXPECT_EQ(calls, 0);
}

TEST(PlanWorkers, refuseWhatTheQueueHasNoRoomFor) {
  std::latch started(1);
  std::latch may_end(1);
  Finished finished;
  {
    PlanWorkers dut(
        [&](auto&&...) -> Expected<Given> {
          started.count_down();
          may_end.wait();
          return Plan{};
        },
        finished.keep(), 1, 2);
    ASSERT_TRUE(dut.offer(job(1)));
    started.wait();
    EXPECT_TRUE(dut.offer(job(2)));
    EXPECT_TRUE(dut.offer(job(3)));
    EXPECT_FALSE(dut.offer(job(4)));
    dut.stop();
    may_end.count_down();
  }
  constexpr int kCancelled = static_cast<int>(ErrorCode::kCancelled);
  EXPECT_EQ(finished.codes,
            (std::multimap<std::uint64_t, int>{{1, kPlan}, {2, kCancelled}, {3, kCancelled}}));
}

TEST(PlanWorkers, finishEveryJobExactlyOnceAlsoWhenDestroyedInTheMiddle) {
  constexpr std::uint64_t kJobs = 500;
  Finished finished;
  {
    PlanWorkers dut(plan, finished.keep(), 3, kJobs);
    for (std::uint64_t i = 0; i < kJobs; ++i) ASSERT_TRUE(dut.offer(job(i)));
  }
  ASSERT_EQ(finished.codes.size(), kJobs);
  for (std::uint64_t i = 0; i < kJobs; ++i) EXPECT_EQ(finished.codes.count(i), 1U) << i;
}

TEST(PlanWorkers, turnWhatAHandlerThrowsIntoAnInternalError) {
  std::promise<Expected<Given>> finished;
  PlanWorkers dut([](auto&&...) -> Expected<Given> { throw std::runtime_error("out of luck"); },
                  [&](const Job&, Expected<Given> answer) { finished.set_value(std::move(answer)); }, 1, 1);
  ASSERT_TRUE(dut.offer(job(1)));
  const Expected<Given> answer = finished.get_future().get();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, ErrorCode::kInternal);
  EXPECT_NE(answer.error().message.find("out of luck"), std::string::npos);
}

}  // namespace
}  // namespace underway
