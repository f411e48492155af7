// Talks to the service as a foreign program would: bare DDS, no PlanClient.
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <limits>
#include <map>
#include <thread>

#include "server/client.hpp"
#include "server/convert.hpp"
#include "server/link.hpp"
#include "server/plan_service.hpp"
#include "server/reply_post.hpp"
#include "tests/server/plan_fixture.hpp"

namespace underway {
namespace {

using dds::Clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr seconds kPatience{60};  // for what must happen: long, for slow machines
constexpr seconds kQuiet{1};      // for what must not happen

/// A client made of bare DDS entities, which may say anything.
class RawClient {
 public:
  RawClient(std::shared_ptr<const Domain> domain, std::string partition)
      : link_(Link::open(std::move(domain)).value()), partition_(std::move(partition)) {
    writer_ = dds::createWriter(link_.participant, link_.request_topic, {.depth = 64}).value();
    dds_set_status_mask(writer_.get(), DDS_PUBLICATION_MATCHED_STATUS);
    EXPECT_TRUE(link_.wait_set.attach(writer_, 1));
    dds_publication_matched_status_t status{};
    const Clock::time_point until = Clock::now() + kPatience;
    while (status.current_count == 0 && Clock::now() < until) {
      EXPECT_TRUE(link_.wait_set.wait(until));
      dds_get_publication_matched_status(writer_.get(), &status);
    }
  }

  void listen(const std::string& user_data = {}) {
    reader_ = dds::createReader(link_.participant, link_.reply_topic,
                                {.partition = partition_, .depth = 64, .user_data = user_data})
                  .value();
    has_replies_ = dds::createReadCondition(reader_).value();
    EXPECT_TRUE(link_.wait_set.attach(has_replies_, 2));
  }

  void send(const underway_PlanRequest& request) {
    EXPECT_EQ(dds_write(writer_.get(), &request), DDS_RETCODE_OK);
  }

  /// Takes replies until there are `count` of them or the time is over; keeps code or -1 for a plan, by
  /// number.
  std::multimap<std::uint64_t, int> take(std::size_t count, milliseconds patience = kPatience) {
    std::multimap<std::uint64_t, int> replies;
    const Clock::time_point until = Clock::now() + patience;
    while (replies.size() < count && Clock::now() < until) {
      EXPECT_TRUE(link_.wait_set.wait(until));
      dds_publication_matched_status_t status{};
      dds_get_publication_matched_status(writer_.get(), &status);
      dds::Loan::take(reader_).value()->forEach<underway_PlanReply>([&](const underway_PlanReply& reply) {
        replies.emplace(reply.id.number, reply.ok ? -1 : static_cast<int>(reply.code));
        last_message = reply.message;
      });
    }
    return replies;
  }

  std::string last_message;

 private:
  Link link_;
  std::string partition_;
  dds::Entity writer_;
  dds::Entity reader_;
  dds::Entity has_replies_;
};

constexpr std::array<std::uint8_t, 16> kClient{7, 7};

underway_PlanRequest request(std::uint64_t number, const char* robot = "nao_1") {
  return **toWire({kClient, number}, fixture::question(robot));  // which holds nothing that has to be freed
}

using Replies = std::multimap<std::uint64_t, int>;
constexpr int kPlan = -1;
constexpr int kInvalid = static_cast<int>(ErrorCode::kInvalidRequest);

struct PlanServiceWire : testing::Test {
  std::shared_ptr<const Domain> domain = fixture::openDomain();
  std::atomic<int> planned = 0;
  PlanService dut = PlanService::start(domain, fixture::served(),
                                       [this](auto&&...) -> Expected<Given> {
                                         ++planned;
                                         return fixture::planWithEverything();
                                       },
                                       {.hold = kPatience})
                        .value();
};

TEST_F(PlanServiceWire, malformedRequestsAreRefusedByFieldAndTheServerLives) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, void (*)(underway_PlanRequest&)> cases[] = {
      {"start.x_m", [](auto& wire) { wire.start.x_m = kNan; }},
      {"goal_y_m", [](auto& wire) { wire.goal_y_m = 1e300; }},
      {"start_mode", [](auto& wire) { std::strcpy(wire.start_mode, "hover"); }},
      {"goal_mode", [](auto& wire) { std::memset(wire.goal_mode, 'a', sizeof wire.goal_mode); }},
      {"policy", [](auto& wire) { std::memset(wire.policy, '\xFF', 64); }},
      {"max_detour", [](auto& wire) { wire.max_detour = -1.0; }},
      {"deadline_ms", [](auto& wire) { wire.deadline_ms = -5; }},
      {"deadline_ms", [](auto& wire) { wire.deadline_ms = std::numeric_limits<std::int32_t>::max(); }},
  };
  RawClient client(domain, "nao_1");
  client.listen();
  std::uint64_t number = 0;
  for (const auto& [field, spoil] : cases) {
    underway_PlanRequest wire = request(++number);
    spoil(wire);
    client.send(wire);
    EXPECT_EQ(client.take(1), (Replies{{number, kInvalid}})) << field;
    EXPECT_TRUE(client.last_message.starts_with(field)) << field << ": " << client.last_message;
  }
  EXPECT_EQ(planned, 0);
  client.send(request(99));
  EXPECT_EQ(client.take(1), (Replies{{99, kPlan}}));
}

TEST_F(PlanServiceWire, aRobotNameThatIsNoneIsAnsweredInTheDefaultPartition) {
  RawClient client(domain, "");
  client.listen();
  std::uint64_t number = 0;
  for (const char* robot : {"", "nao 1", "*", "nao_?", "a/b", "\xC3\xA9"}) {
    underway_PlanRequest wire = request(++number);
    std::memset(wire.robot, 0, sizeof wire.robot);
    std::strcpy(wire.robot, robot);
    client.send(wire);
    EXPECT_EQ(client.take(1), (Replies{{number, kInvalid}})) << robot;
    EXPECT_TRUE(client.last_message.starts_with("robot")) << client.last_message;
  }
}

TEST_F(PlanServiceWire, aResendIsAnsweredAgainButPlannedOnce) {
  RawClient client(domain, "nao_1");
  client.listen();
  for (int i = 0; i < 3; ++i) {
    client.send(request(5));
    EXPECT_EQ(client.take(1), (Replies{{5, kPlan}})) << i;
  }
  EXPECT_EQ(planned, 1);
  EXPECT_EQ(client.take(1, kQuiet), Replies{});
}

TEST_F(PlanServiceWire, aReplyWaitsForAReaderThatComesLate) {
  RawClient client(domain, "nao_1");
  client.send(request(1));
  std::this_thread::sleep_for(milliseconds(500));
  client.listen(userDataOf(kClient));
  EXPECT_EQ(client.take(1), (Replies{{1, kPlan}}));
  EXPECT_EQ(planned, 1);
}

TEST_F(PlanServiceWire, aReplyIsNotWastedOnAnotherClientsReader) {
  RawClient other(domain, "nao_1");
  other.listen(userDataOf({1}));
  RawClient client(domain, "nao_1");
  client.send(request(1));
  EXPECT_EQ(other.take(1, kQuiet), Replies{});
  client.listen(userDataOf(kClient));
  EXPECT_EQ(client.take(1), (Replies{{1, kPlan}}));
}

TEST_F(PlanServiceWire, aReplyIsNotSentToAnotherRobot) {
  RawClient other(domain, "nao_2");
  other.listen();
  RawClient client(domain, "nao_1");
  client.listen();
  client.send(request(1));
  EXPECT_EQ(client.take(1), (Replies{{1, kPlan}}));
  EXPECT_EQ(other.take(1, kQuiet), Replies{});
}

TEST(PlanServiceWireStill, aReplyThatNobodyFetchesDoesNotKeepTheServiceFromEnding) {
  const auto domain = fixture::openDomain();
  std::atomic<bool> is_planned = false;
  PlanService dut = PlanService::start(domain, fixture::served(),
                                       [&](auto&&...) -> Expected<Given> {
                                         is_planned = true;
                                         return fixture::planWithEverything();
                                       },
                                       {.hold = milliseconds(200)})
                        .value();
  RawClient client(domain, "nao_1");
  client.send(request(1));
  while (!is_planned) std::this_thread::yield();
  dut.stop();
  EXPECT_TRUE(dut.wait().has_value());
}

TEST(PlanServiceWireStill, aResendOfWhatIsBeingPlannedIsNotPlannedAgain) {
  const auto domain = fixture::openDomain();
  std::atomic<int> planned = 0;
  std::atomic<bool> may_end = false;
  const PlanService dut = PlanService::start(domain, fixture::served(),
                                             [&](auto&&...) -> Expected<Given> {
                                               ++planned;
                                               may_end.wait(false);
                                               return fixture::planWithEverything();
                                             },
                                             {.threads = 2})
                              .value();
  RawClient client(domain, "nao_1");
  client.listen();
  for (int i = 0; i < 5; ++i) client.send(request(1));
  client.send(request(2, "nao_1"));
  while (planned < 2) std::this_thread::yield();  // by then all resends have been taken
  may_end = true;
  may_end.notify_all();
  EXPECT_EQ(client.take(2), (Replies{{1, kPlan}, {2, kPlan}}));
  EXPECT_EQ(client.take(1, kQuiet), Replies{});
  EXPECT_EQ(planned, 2);
}

TEST(PlanServiceWireBusy, oneTooManyIsBusyAndStaysSo) {
  const auto domain = fixture::openDomain();
  std::atomic<int> planned = 0;
  std::atomic<bool> may_end = false;
  const PlanService dut = PlanService::start(domain, fixture::served(),
                                             [&](auto&&...) -> Expected<Given> {
                                               ++planned;
                                               may_end.wait(false);
                                               return fixture::planWithEverything();
                                             },
                                             {.threads = 1, .most_queued = 1})
                              .value();
  constexpr int kBusy = static_cast<int>(ErrorCode::kBusy);
  RawClient client(domain, "nao_1");
  client.listen();
  client.send(request(1));
  while (planned == 0) std::this_thread::yield();
  for (std::uint64_t number : {2, 3, 4}) client.send(request(number));
  EXPECT_EQ(client.take(2), (Replies{{3, kBusy}, {4, kBusy}}));
  client.send(request(4));
  EXPECT_EQ(client.take(1), (Replies{{4, kBusy}}));
  may_end = true;
  may_end.notify_all();
  EXPECT_EQ(client.take(2), (Replies{{1, kPlan}, {2, kPlan}}));
}

TEST(PlanServiceWireEnd, aBurstThatCameBeforeTheEndIsAnsweredToTheLast) {
  constexpr std::uint64_t kBurst = 60;  // no deeper than the replies that a reader keeps
  const auto domain = fixture::openDomain();
  std::atomic<bool> is_planning = false;
  PlanService dut = PlanService::start(
                        domain, fixture::served(),
                        [&](const Asked&, Clock::time_point, const std::stop_token& stop) -> Expected<Given> {
                          is_planning = true;
                          while (!stop.stop_requested()) std::this_thread::yield();
                          return fail(ErrorCode::kCancelled, "stopped");
                        },
                        {.threads = 1})
                        .value();
  RawClient client(domain, "nao_1");
  client.listen();
  client.send(request(0));
  while (!is_planning) std::this_thread::yield();
  Replies expected{{0, static_cast<int>(ErrorCode::kCancelled)}};
  for (std::uint64_t number = 1; number < kBurst; ++number) {
    client.send(request(number));
    expected.emplace(number, static_cast<int>(ErrorCode::kCancelled));
  }
  dut.stop();
  EXPECT_TRUE(dut.wait().has_value());
  EXPECT_EQ(client.take(kBurst), expected);
}

TEST(PlanClientWire, saysWhenTheServerWentAway) {
  const auto domain = fixture::openDomain();
  Expected<PlanClient> dut = PlanClient::open(domain, {.discovery = kPatience});
  ASSERT_TRUE(dut) << dut.error().message;
  std::jthread mute([&] {  // takes one request, and is gone
    Link link = Link::open(domain).value();
    const dds::Entity reader = dds::createReader(link.participant, link.request_topic, {.depth = 1}).value();
    const dds::Entity has_requests = dds::createReadCondition(reader).value();
    EXPECT_TRUE(link.wait_set.attach(has_requests, 1));
    EXPECT_TRUE(link.wait_set.wait(Clock::now() + kPatience));
  });
  const Expected<PlanDocument> document = dut->ask(fixture::question(), seconds(3));
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::kNoServer);
  EXPECT_NE(document.error().message.find("went away"), std::string::npos) << document.error().message;
}

}  // namespace
}  // namespace underway
