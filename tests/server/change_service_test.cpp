#include "server/change_service.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <map>
#include <mutex>
#include <random>
#include <thread>

#include "planner/certify.hpp"
#include "server/change_client.hpp"
#include "server/client.hpp"
#include "server/convert_change.hpp"
#include "server/link.hpp"
#include "server/plan_service.hpp"
#include "server/reply_post.hpp"
#include "tests/planner/fixture.hpp"
#include "tests/server/plan_fixture.hpp"

/// The world of a real planner, changed over real DDS.
namespace underway {
namespace {

using dds::Clock;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Kind = WorldChange::Kind;

constexpr seconds kPatience{60};  // for what must happen: long, for slow machines
constexpr seconds kQuiet{1};      // for what must not happen

const OrientedBox kBox{{3.0, 2.0, 0.2}, {0.4, 0.4, 0.4}, {}};
const OrientedBox kAside{{3.0, 3.5, 0.2}, {0.4, 0.4, 0.4}, {}};

struct ChangeServiceTest : testing::Test {
  std::shared_ptr<const Domain> domain = fixture::openDomain();
  std::shared_ptr<Planner> planner = std::make_shared<Planner>(test::ourWorld("scenario3"), test::nao());
  ChangeService dut = ChangeService::start(domain, planner, {}, {.hold = kPatience}).value();

  [[nodiscard]] ChangeClient client() const {
    return ChangeClient::open(domain, {.discovery = kPatience}).value();
  }
  [[nodiscard]] std::uint64_t revision() const { return planner->checker()->world().revision(); }
};

ChangeAnswer ask(ChangeClient& client, std::vector<WorldChange> changes, std::uint64_t if_revision = 0) {
  Expected<ChangeAnswer> answer = client.ask({"operator", std::move(changes), if_revision}, kPatience);
  EXPECT_TRUE(answer.has_value()) << answer.error().message;
  return std::move(*answer);
}

TEST_F(ChangeServiceTest, tellsHowTheWorldIsWithoutAnyChange) {
  ChangeClient asker = client();
  const ChangeAnswer answer = ask(asker, {});
  const World& world = planner->checker()->world();
  EXPECT_TRUE(answer.repaired);
  EXPECT_EQ(answer.world.map_name, "scenario3");
  EXPECT_EQ(answer.world.revision, 1U);
  EXPECT_EQ(answer.world.hash, world.hash());
  EXPECT_EQ(answer.world.obstacles, world.obstacles().size());
}

TEST_F(ChangeServiceTest, addsMovesAndRemovesWithNewRevisionsAndCounts) {
  planner->prepare(test::soon());
  ChangeClient asker = client();
  const ChangeAnswer added = ask(asker, {{Kind::kAdd, "box", kBox}});
  ASSERT_TRUE(added.repaired) << added.repaired.error().message;
  EXPECT_EQ(added.world.revision, 2U);
  EXPECT_EQ(added.world.hash, planner->checker()->world().hash());
  EXPECT_GT(added.repaired->closed, 0U);
  EXPECT_GE(added.repaired->checked, 1U);

  const ChangeAnswer moved = ask(asker, {{Kind::kMove, "box", kAside}});
  EXPECT_EQ(moved.world.revision, 3U);
  EXPECT_EQ(moved.world.obstacles, added.world.obstacles);
  EXPECT_GT(moved.repaired->opened, 0U);

  const ChangeAnswer removed = ask(asker, {{Kind::kRemove, "box"}});
  EXPECT_EQ(removed.world.revision, 4U);
  EXPECT_EQ(removed.world.obstacles, added.world.obstacles - 1);
  EXPECT_EQ(removed.world.hash, test::ourWorld("scenario3")->hash());
}

TEST_F(ChangeServiceTest, makesAllChangesOrNone) {
  ChangeClient asker = client();
  const ChangeAnswer answer = ask(asker, {{Kind::kAdd, "box", kBox}, {Kind::kRemove, "chair"}});
  ASSERT_FALSE(answer.repaired);
  EXPECT_EQ(answer.repaired.error().code, ErrorCode::kInvalidRequest);
  EXPECT_NE(answer.repaired.error().message.find("change 2"), std::string::npos);
  EXPECT_EQ(answer.world.revision, 1U);
  EXPECT_EQ(revision(), 1U);
}

TEST_F(ChangeServiceTest, changesOnlyTheRevisionThatWasMeant) {
  ChangeClient asker = client();
  EXPECT_TRUE(ask(asker, {{Kind::kAdd, "box", kBox}}, 1).repaired);
  const ChangeAnswer late = ask(asker, {{Kind::kRemove, "box"}}, 1);
  ASSERT_FALSE(late.repaired);
  EXPECT_EQ(late.repaired.error().code, ErrorCode::kStaleRevision);
  EXPECT_NE(late.repaired.error().message.find("revision 2, not 1"), std::string::npos)
      << late.repaired.error().message;
  EXPECT_EQ(late.world.revision, 2U);
  EXPECT_TRUE(ask(asker, {{Kind::kRemove, "box"}}, 2).repaired);
}

TEST_F(ChangeServiceTest, refusesToSendWhatTheWireCannotCarry) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  ChangeClient asker = client();
  const std::pair<WorldChange, const char*> cases[] = {
      {{Kind::kAdd, "", kBox}, "changes[0]: obstacle"},
      {{Kind::kAdd, std::string(256, 'a'), kBox}, "changes[0]: obstacle"},
      {{Kind::kAdd, "a\nb", kBox}, "changes[0]: obstacle"},
      {{Kind::kAdd, "box", {{kNan, 0, 0}, {1, 1, 1}, {}}}, "changes[0]: center_m"},
      {{Kind::kMove, "box", {{0, 0, 0}, {1, -1, 1}, {}}}, "changes[0]: size_m"},
      {{Kind::kAdd, "box", {{0, 0, 0}, {1, 1, 1}, {0, 1e9, 0}}}, "changes[0]: rpy_rad"},
  };
  for (const auto& [change, says] : cases) {
    const auto answer = asker.ask({"operator", {change}}, kPatience);
    ASSERT_FALSE(answer) << says;
    EXPECT_TRUE(answer.error().message.starts_with(says)) << answer.error().message;
  }
  EXPECT_FALSE(asker.ask({"operator", std::vector<WorldChange>(1025, {Kind::kRemove, "box"})}, kPatience));
  EXPECT_FALSE(asker.ask({"no name", {}}, kPatience));
  EXPECT_EQ(revision(), 1U);
}

TEST_F(ChangeServiceTest, twoClientsAtOnceLoseNoChange) {
  constexpr int kEach = 25;
  {
    std::vector<std::jthread> askers;
    for (const char* who : {"a", "b"})
      askers.emplace_back([this, who] {
        ChangeClient asker = client();
        for (int i = 0; i < kEach; ++i)
          EXPECT_TRUE(ask(asker, {{Kind::kAdd, who + std::to_string(i), kAside}}).repaired);
      });
  }
  EXPECT_EQ(revision(), 1U + 2 * kEach);
  EXPECT_EQ(planner->checker()->world().obstacles().size(),
            test::ourWorld("scenario3")->obstacles().size() + 2 * kEach);
}

/// Speaks to the service as a foreign program would, and may say anything.
class RawChanger {
 public:
  explicit RawChanger(std::shared_ptr<const Domain> domain)
      : link_(Link::open(std::move(domain), changeTopics()).value()) {
    writer_ = dds::createWriter(link_.participant, link_.request_topic, {.depth = 64}).value();
    dds_set_status_mask(writer_.get(), DDS_PUBLICATION_MATCHED_STATUS);
    EXPECT_TRUE(link_.wait_set.attach(writer_, 1));
    reader_ = dds::createReader(link_.participant, link_.reply_topic, {.partition = "operator", .depth = 64})
                  .value();
    has_replies_ = dds::createReadCondition(reader_).value();
    EXPECT_TRUE(link_.wait_set.attach(has_replies_, 2));
    dds_publication_matched_status_t status{};
    const Clock::time_point until = Clock::now() + kPatience;
    while (status.current_count == 0 && Clock::now() < until) {
      EXPECT_TRUE(link_.wait_set.wait(until));
      dds_get_publication_matched_status(writer_.get(), &status);
    }
  }
  void send(const underway_ChangeRequest& request) {
    EXPECT_EQ(dds_write(writer_.get(), &request), DDS_RETCODE_OK);
  }
  /// The revisions that replies tell, by the requests' numbers.
  std::multimap<std::uint64_t, std::uint64_t> take(std::size_t count, milliseconds patience = kPatience) {
    std::multimap<std::uint64_t, std::uint64_t> replies;
    const Clock::time_point until = Clock::now() + patience;
    while (replies.size() < count && Clock::now() < until) {
      EXPECT_TRUE(link_.wait_set.wait(until));
      dds_publication_matched_status_t status{};
      dds_get_publication_matched_status(writer_.get(), &status);
      dds::Loan::take(reader_).value()->forEach<underway_ChangeReply>([&](const underway_ChangeReply& reply) {
        replies.emplace(reply.id.number, reply.world.revision);
        last_message = reply.message;
      });
    }
    return replies;
  }
  std::string last_message;

 private:
  Link link_;
  dds::Entity writer_;
  dds::Entity reader_;
  dds::Entity has_replies_;
};

WireChangeRequest addition(std::uint64_t number, const std::string& id) {
  return std::move(*toWire({{7, 7}, number}, {"operator", {{Kind::kAdd, id, kAside}}}));
}

using Replies = std::multimap<std::uint64_t, std::uint64_t>;

TEST_F(ChangeServiceTest, aResendIsAnsweredAgainButMadeOnce) {
  RawChanger asker(domain);
  const WireChangeRequest wire = addition(5, "box");
  for (int i = 0; i < 3; ++i) {
    asker.send(*wire);
    EXPECT_EQ(asker.take(1), (Replies{{5, 2}})) << i;
  }
  EXPECT_EQ(revision(), 2U);
  EXPECT_EQ(asker.take(1, kQuiet), Replies{});
}

TEST_F(ChangeServiceTest, malformedRequestsAreRefusedByFieldAndTheServerLives) {
  const std::pair<const char*, void (*)(underway_ChangeRequest&)> cases[] = {
      {"changes[0]: obstacle", [](auto& wire) { wire.changes._buffer[0].obstacle[0] = '\x07'; }},
      {"changes[0]: size_m", [](auto& wire) { wire.changes._buffer[0].size_m.z = 0.0; }},
      {"changes[0]: center_m",
       [](auto& wire) { wire.changes._buffer[0].center_m.y = std::numeric_limits<double>::infinity(); }},
  };
  RawChanger asker(domain);
  std::uint64_t number = 0;
  for (const auto& [field, spoil] : cases) {
    const WireChangeRequest wire = addition(++number, "box");
    spoil(*wire);
    asker.send(*wire);
    EXPECT_EQ(asker.take(1), (Replies{{number, 1}})) << field;
    EXPECT_TRUE(asker.last_message.starts_with(field)) << asker.last_message;
  }
  asker.send(*addition(99, "box"));
  EXPECT_EQ(asker.take(1), (Replies{{99, 2}}));
}

TEST(ConvertChange, refusesWhatIsOutOfRangeUnread) {
  const WireChangeRequest wire = addition(1, "box");
  const auto messageWith = [&](const auto& spoil) {
    underway_ChangeRequest spoilt = *wire;  // shares its changes
    const underway_Change kept = wire->changes._buffer[0];
    spoil(spoilt);
    const auto changes = fromWire(spoilt);
    wire->changes._buffer[0] = kept;
    return changes ? "taken" : changes.error().message;
  };
  EXPECT_EQ(messageWith([](auto&) {}), "taken");
  EXPECT_TRUE(messageWith([](auto& spoilt) {
                std::memset(&spoilt.changes._buffer[0].kind, 3, 1);
              }).starts_with("changes[0]: kind"));
  EXPECT_TRUE(messageWith([](auto& spoilt) {
                std::memset(spoilt.changes._buffer[0].obstacle, 'a', 256);
              }).starts_with("changes[0]: obstacle"));
  EXPECT_TRUE(
      messageWith([](auto& spoilt) { spoilt.changes._length = 1025; }).starts_with("changes must be"));
  EXPECT_TRUE(
      messageWith([](auto& spoilt) { spoilt.changes._buffer = nullptr; }).starts_with("changes must be"));
  EXPECT_TRUE(messageWith([](auto& spoilt) { spoilt.robot[0] = '*'; }).starts_with("robot must be"));
}

TEST_F(ChangeServiceTest, whoComesLateLearnsTheRevisionToo) {
  ChangeClient asker = client();
  ASSERT_TRUE(ask(asker, {{Kind::kAdd, "box", kBox}}).repaired);
  const dds::Entity participant = dds::createParticipant(*domain).value();
  const dds::Entity topic = dds::createTopic(participant, underway_WorldState_desc, "underway/world").value();
  const dds::Entity reader =
      dds::createReader(participant, topic, {.depth = 16, .is_for_latecomers = true}).value();
  const dds::Entity has_states = dds::createReadCondition(reader).value();
  dds::WaitSet wait_set = dds::WaitSet::create(participant).value();
  ASSERT_TRUE(wait_set.attach(has_states, 1));
  std::vector<std::uint64_t> revisions;
  const auto takeUntil = [&](std::uint64_t last) {
    const Clock::time_point until = Clock::now() + kPatience;
    while ((revisions.empty() || revisions.back() < last) && Clock::now() < until) {
      ASSERT_TRUE(wait_set.wait(until));
      dds::Loan::take(reader).value()->forEach<underway_WorldState>(
          [&](const underway_WorldState& state) { revisions.push_back(state.revision); });
    }
  };
  takeUntil(2);
  EXPECT_EQ(revisions, (std::vector<std::uint64_t>{2}));
  ASSERT_TRUE(ask(asker, {{Kind::kRemove, "box"}}).repaired);
  takeUntil(3);
  EXPECT_EQ(revisions, (std::vector<std::uint64_t>{2, 3}));
}

TEST_F(ChangeServiceTest, endsAtOnceWhenNothingIsAsked) {
  dut.stop();
  EXPECT_TRUE(dut.wait().has_value());
  dut.stop();
}

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
