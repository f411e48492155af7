#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <random>
#include <thread>

#include "planner/certify.hpp"
#include "server/change_service.hpp"
#include "server/client.hpp"
#include "server/plan_service.hpp"
#include "tests/server/change_fixture.hpp"

namespace underway {
namespace {

using fixture::ask;
using fixture::ChangeServiceTest;
using fixture::kPatience;
using Kind = WorldChange::Kind;

/// The whole: a world that changes while robots ask, replan and check.
struct ChangingWorld : ChangeServiceTest {
  PlanService plans = PlanService::start(domain, served(), handlerFor(planner), {.threads = 2}).value();

  static Served served() { return {*test::nao(), "scenario3", hashOf(*test::nao()), 1}; }
  [[nodiscard]] PlanClient planClient() const {
    return PlanClient::open(domain, {.discovery = kPatience}).value();
  }
  static Question question() {
    Question question;
    question.robot = "nao_1";
    question.start = {0.6, 2.0, 0.0};
    question.goal = {5.4, 2.0};
    question.goal_yaw = 0.0;
    question.policy = Policy::kFastest;
    question.deadline = kPatience;
    return question;
  }
  static Question followUp(const PlanDocument& document, Purpose purpose) {
    Question question = ChangingWorld::question();
    question.purpose = purpose;
    question.followed = {{*document.answer, 0, 0.0}, document.mode_names};
    return question;
  }
  static PlanDocument answerOf(PlanClient& asker, const Question& question) {
    const auto document = asker.ask(question, kPatience);
    EXPECT_TRUE(document.has_value()) << document.error().message;
    return *document;
  }
  /// A box in the middle of the plan's longest translation.
  static OrientedBox boxOn(const Plan& plan) {
    const auto longest = std::max_element(
        plan.segments.begin(), plan.segments.end(),
        [](const Segment& a, const Segment& b) { return length(a.motion) < length(b.motion); });
    const Motion& motion = longest->motion;
    return {
        {0.5 * (motion.from.x + motion.to.x), 0.5 * (motion.from.y + motion.to.y), 0.1}, {0.1, 0.1, 0.2}, {}};
  }
};

TEST_F(ChangingWorld, aPlanIsStaleOnceItIsBlockedAndReplanningLeavesIt) {
  PlanClient asker = planClient();
  ChangeClient changer = client();
  const PlanDocument first = answerOf(asker, question());
  ASSERT_TRUE(first.answer) << first.answer.error().message;
  EXPECT_EQ(first.revision, 1U);

  const PlanDocument holds = answerOf(asker, followUp(first, Purpose::kCheck));
  ASSERT_TRUE(holds.answer) << holds.answer.error().message;
  EXPECT_FALSE(holds.choice->is_new);
  EXPECT_EQ(holds.answer->segments.size(), first.answer->segments.size());

  const PlanDocument kept = answerOf(asker, followUp(first, Purpose::kReplan));
  ASSERT_TRUE(kept.answer && kept.choice);
  EXPECT_FALSE(kept.choice->is_new) << kept.choice->why;
  EXPECT_TRUE(certify(*kept.answer, kept.request, *planner->checker()).empty());

  ASSERT_TRUE(ask(changer, {{Kind::kAdd, "box", boxOn(*first.answer)}}).repaired);
  const PlanDocument stale = answerOf(asker, followUp(first, Purpose::kCheck));
  ASSERT_FALSE(stale.answer);
  EXPECT_EQ(stale.answer.error().code, ErrorCode::kStaleRevision);
  EXPECT_NE(stale.answer.error().message.find("blocked now by box"), std::string::npos)
      << stale.answer.error().message;
  EXPECT_EQ(stale.revision, 2U);

  const PlanDocument fresh = answerOf(asker, followUp(first, Purpose::kReplan));
  ASSERT_TRUE(fresh.answer) << fresh.answer.error().message;
  EXPECT_TRUE(fresh.choice->is_new);
  EXPECT_EQ(fresh.choice->why, stale.answer.error().message);
  EXPECT_EQ(fresh.revision, 2U);
  EXPECT_EQ(fresh.world_hash, planner->checker()->world().hash());
  EXPECT_TRUE(certify(*fresh.answer, fresh.request, *planner->checker()).empty());
}

TEST_F(ChangingWorld, whatWasNoPlanIsRefused) {
  PlanClient asker = planClient();
  const PlanDocument first = answerOf(asker, question());
  Question spoilt = followUp(first, Purpose::kReplan);
  spoilt.followed.executing.plan.segments[0].motion.to.yaw += 0.5;
  const PlanDocument refused = answerOf(asker, spoilt);
  ASSERT_FALSE(refused.answer);
  EXPECT_NE(refused.answer.error().code, ErrorCode::kInternal);
}

TEST_F(ChangingWorld, plansNameTheWorldTheyWereMadeInHoweverFastItChanges) {
  constexpr std::size_t kChanges = 60;
  constexpr std::size_t kAnswers = 30;
  std::map<std::uint64_t, std::shared_ptr<const Checker>> worlds{{1, planner->checker()}};
  std::vector<PlanDocument> documents;
  std::mutex mutex;
  {
    std::atomic<bool> is_over = false;
    std::vector<std::jthread> robots;
    for (const Purpose purpose : {Purpose::kPlan, Purpose::kReplan, Purpose::kCheck})
      robots.emplace_back([&, purpose] {
        PlanClient asker = planClient();
        const PlanDocument first = answerOf(asker, question());
        while (!is_over) {
          Question next = followUp(first, purpose);
          next.robot = "nao_" + std::to_string(static_cast<int>(purpose));
          const PlanDocument document = answerOf(asker, next);
          const std::scoped_lock lock(mutex);
          documents.push_back(document);
        }
      });
    ChangeClient changer = client();
    std::mt19937 random(5);
    const auto answers = [&] {
      const std::scoped_lock lock(mutex);
      return documents.size();
    };
    for (std::size_t i = 0; i < kChanges || answers() < kAnswers; ++i) {
      const double x = 1.0 + 4.0 * static_cast<double>(random() % 1000) / 1000.0;
      const OrientedBox box{
          {x, 0.3 + 3.0 * static_cast<double>(random() % 1000) / 1000.0, 0.2}, {0.3, 0.3, 0.4}, {}};
      const Kind kind = i == 0 ? Kind::kAdd : Kind::kMove;
      ASSERT_EQ(ask(changer, {{kind, "box", box}}).world.revision, i + 2);
      worlds[planner->checker()->world().revision()] = planner->checker();
    }
    is_over = true;
  }
  std::size_t plans_made = 0;
  for (const PlanDocument& document : documents) {
    ASSERT_TRUE(worlds.contains(document.revision)) << document.revision;
    const Checker& checker = *worlds.at(document.revision);
    EXPECT_EQ(document.world_hash, checker.world().hash());
    if (!document.answer) continue;
    ++plans_made;
    const auto flaws = certify(*document.answer, document.request, checker);
    EXPECT_TRUE(flaws.empty()) << flaws.front().sentence;
  }
  EXPECT_GT(plans_made, 0U);
}

}  // namespace
}  // namespace underway
