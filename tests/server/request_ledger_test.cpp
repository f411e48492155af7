#include "server/request_ledger.hpp"

#include <gtest/gtest.h>

#include "server/convert.hpp"
#include "tests/server/plan_fixture.hpp"

namespace underway {
namespace {

FinalReply answerTo(std::uint64_t sequence, const Expected<Plan>& plan) {
  const RequestId id{{}, sequence};
  return {id, "nao_1", toWire(id, fixture::served(), plan), plan ? plan->segments.size() : 0};
}

TEST(RequestLedger, aRequestIsUnknownThenInFlightThenAnswered) {
  RequestLedger dut;
  const FinalReply answer = answerTo(1, fail(ErrorCode::kTimeout, "late"));
  EXPECT_FALSE(dut.isInFlight(answer.id));
  EXPECT_EQ(dut.answerTo(answer.id), nullptr);
  dut.begin(answer.id);
  EXPECT_TRUE(dut.isInFlight(answer.id));
  EXPECT_EQ(dut.inFlight(), 1U);
  dut.finish(answer);
  EXPECT_FALSE(dut.isInFlight(answer.id));
  ASSERT_NE(dut.answerTo(answer.id), nullptr);
  EXPECT_EQ(dut.answerTo(answer.id)->reply, answer.reply);
}

TEST(RequestLedger, clientsWithTheSameCountAreToldApart) {
  RequestLedger dut;
  dut.begin({{1}, 5});
  EXPECT_TRUE(dut.isInFlight({{1}, 5}));
  EXPECT_FALSE(dut.isInFlight({{2}, 5}));
}

TEST(RequestLedger, forgetsTheOldestAnswersByWeight) {
  const Expected<Plan> plan = fixture::planWithEverything();  // weighs 10 and its three segments
  RequestLedger dut(30);
  for (std::uint64_t i = 0; i < 3; ++i) dut.finish(answerTo(i, plan));
  EXPECT_EQ(dut.answerTo({{}, 0}), nullptr);
  EXPECT_NE(dut.answerTo({{}, 1}), nullptr);
  EXPECT_NE(dut.answerTo({{}, 2}), nullptr);
}

TEST(RequestLedger, keepsTheLastAnswerHoweverHeavy) {
  RequestLedger dut(1);
  dut.finish(answerTo(1, fixture::planWithEverything()));
  EXPECT_NE(dut.answerTo({{}, 1}), nullptr);
  dut.finish(answerTo(2, fixture::planWithEverything()));
  EXPECT_EQ(dut.answerTo({{}, 1}), nullptr);
  EXPECT_NE(dut.answerTo({{}, 2}), nullptr);
}

TEST(RequestLedger, answeringTwiceKeepsTheFirst) {
  RequestLedger dut;
  const FinalReply first = answerTo(1, fail(ErrorCode::kTimeout, "first"));
  dut.finish(first);
  dut.finish(answerTo(1, fail(ErrorCode::kTimeout, "second")));
  EXPECT_EQ(dut.answerTo(first.id)->reply, first.reply);
}

}  // namespace
}  // namespace underway
