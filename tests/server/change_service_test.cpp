#include "server/change_service.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <thread>

#include "server/convert_change.hpp"
#include "server/link.hpp"
#include "server/reply_post.hpp"
#include "tests/server/change_fixture.hpp"

/// The world of a real planner, changed over real DDS.
namespace underway {
namespace {

using dds::Clock;
using fixture::ask;
using fixture::ChangeServiceTest;
using fixture::kPatience;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Kind = WorldChange::Kind;

constexpr seconds kQuiet{1};  // for what must not happen

const OrientedBox kBox{{3.0, 2.0, 0.2}, {0.4, 0.4, 0.4}, {}};
const OrientedBox kAside{{3.0, 3.5, 0.2}, {0.4, 0.4, 0.4}, {}};

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

TEST_F(ChangeServiceTest, removesAllThatOneHasAddedTogether) {
  ChangeClient asker = client();
  ASSERT_TRUE(ask(asker, {{Kind::kAdd, "a.seen_1", kBox}, {Kind::kAdd, "b.seen_1", kAside}}).repaired);
  const ChangeAnswer answer = ask(asker, {{Kind::kRemoveAll, "a."}});
  ASSERT_TRUE(answer.repaired) << answer.repaired.error().message;
  EXPECT_EQ(answer.world.revision, 4U);
  EXPECT_TRUE(planner->checker()->world().obstacles().find("b.seen_1"));
  EXPECT_FALSE(planner->checker()->world().obstacles().find("a.seen_1"));
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
                std::memset(&spoilt.changes._buffer[0].kind, 4, 1);
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

}  // namespace
}  // namespace underway
