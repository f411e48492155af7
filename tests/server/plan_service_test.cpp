#include "server/plan_service.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "server/client.hpp"
#include "tests/server/plan_fixture.hpp"

namespace underway {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Deadline = std::chrono::steady_clock::time_point;

constexpr seconds kPatience{60};  // for replies that must come: long, for slow machines

/// Plans that tell the request apart: their first pose's x repeats the request's.
Expected<Given> echo(const Asked& asked, Deadline, std::stop_token) {
  return fixture::planWithEverything(asked.request.start.x);
}

/// Waits to be told to stop, as a planner in the middle of a search would notice.
Expected<Given> untilStopped(std::stop_token stopping) {
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  stopped.wait(lock, stopping, [] { return false; });
  return fail(ErrorCode::kCancelled, "stopped");
}

PlanService serve(std::shared_ptr<const Domain> domain, PlanHandler handler,
                  PlanServiceSettings settings = {}) {
  Expected<PlanService> service =
      PlanService::start(std::move(domain), fixture::served(), std::move(handler), settings);
  EXPECT_TRUE(service.has_value()) << service.error().message;
  return std::move(*service);
}

PlanClient client(std::shared_ptr<const Domain> domain) {
  Expected<PlanClient> client = PlanClient::open(std::move(domain), {.discovery = kPatience});
  EXPECT_TRUE(client.has_value()) << client.error().message;
  return std::move(*client);
}

ErrorCode codeOf(const Expected<PlanDocument>& document) {
  if (!document) return document.error().code;
  EXPECT_FALSE(document->answer.has_value());
  return document->answer ? ErrorCode::kInternal : document->answer.error().code;
}

TEST(PlanService, aReplyEqualsWhatPlanningOnTheSpotGives) {
  const auto domain = fixture::openDomain();
  const PlanService dut = serve(domain, echo);
  PlanClient asker = client(domain);
  const Question question = fixture::question();
  const Expected<PlanDocument> document = asker.ask(question, kPatience);
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(toJson(*document), toJson(fixture::documentFor(question, fixture::served(),
                                                           fixture::planWithEverything(question.start.x))));
}

TEST(PlanService, theHandlerSeesTheRequestAndADeadlineFromArrival) {
  const auto domain = fixture::openDomain();
  const auto before = std::chrono::steady_clock::now();
  Request seen;
  Deadline deadline;
  const PlanService dut = serve(domain, [&](const Asked& asked, Deadline until, std::stop_token stop) {
    seen = asked.request;
    deadline = until;
    return echo(asked, until, std::move(stop));
  });
  PlanClient asker = client(domain);
  Question question = fixture::question();
  question.deadline = milliseconds(600'000);
  ASSERT_TRUE(asker.ask(question, kPatience));
  EXPECT_EQ(seen.goal, question.goal);
  EXPECT_EQ(seen.goal_mode, 2);
  EXPECT_GE(deadline, before + question.deadline);
  EXPECT_LE(deadline, std::chrono::steady_clock::now() + question.deadline);
}

TEST(PlanService, failuresOfTheHandlerArriveAsTheyAre) {
  const auto domain = fixture::openDomain();
  const Error error{
      ErrorCode::kNoPathExists, "the table is too low", {{"table", "crawl", "height", 0.21, 0.19}}, 9, "abc"};
  const PlanService dut = serve(domain, [&](auto&&...) -> Expected<Plan> { return tl::unexpected(error); });
  PlanClient asker = client(domain);
  const Question question = fixture::question();
  const Expected<PlanDocument> document = asker.ask(question, kPatience);
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(toJson(*document),
            toJson(fixture::documentFor(question, fixture::served(), tl::unexpected(error))));
}

TEST(PlanService, aHandlerThatThrowsIsAnInternalErrorAndTheServerLives) {
  const auto domain = fixture::openDomain();
  std::atomic<int> calls = 0;
  const PlanService dut = serve(domain, [&](const Asked& asked, Deadline until, std::stop_token stop) {
    if (calls++ == 0) throw std::runtime_error("out of luck");
    return echo(asked, until, std::move(stop));
  });
  PlanClient asker = client(domain);
  const Expected<PlanDocument> first = asker.ask(fixture::question(), kPatience);
  EXPECT_EQ(codeOf(first), ErrorCode::kInternal);
  EXPECT_NE(first->answer.error().message.find("out of luck"), std::string::npos);
  const Expected<PlanDocument> second = asker.ask(fixture::question(), kPatience);
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_TRUE(second->answer.has_value());
}

TEST(PlanService, anUnknownModeIsRefusedByName) {
  const auto domain = fixture::openDomain();
  const PlanService dut = serve(domain, echo);
  PlanClient asker = client(domain);
  Question question = fixture::question();
  question.start_mode = "hover";
  const Expected<PlanDocument> document = asker.ask(question, kPatience);
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::kInvalidRequest);
  EXPECT_NE(document.error().message.find("frontal, lateral, crawl"), std::string::npos)
      << document.error().message;
}

TEST(PlanService, oneClientMayAskForSeveralRobots) {
  const auto domain = fixture::openDomain();
  const PlanService dut = serve(domain, echo);
  PlanClient asker = client(domain);
  for (const char* robot : {"nao_1", "nao_2", "nao_1"}) {
    const Expected<PlanDocument> document = asker.ask(fixture::question(robot), kPatience);
    ASSERT_TRUE(document) << document.error().message;
    EXPECT_TRUE(document->answer.has_value());
  }
}

/// Asks `count` questions, all different, and tells how many were answered with just their own plan.
int askMany(PlanClient& asker, const std::string& robot, int first, int count) {
  int right = 0;
  for (int i = first; i < first + count; ++i) {
    const Question question = fixture::question(robot, i);
    const Expected<PlanDocument> document = asker.ask(question, kPatience);
    const PlanDocument expected =
        fixture::documentFor(question, fixture::served(), fixture::planWithEverything(i));
    right += document && toJson(*document) == toJson(expected) ? 1 : 0;
  }
  return right;
}

TEST(PlanService, eightClientsAtOnceEachGetJustTheirOwnReplies) {
  constexpr int kClients = 8;
  constexpr int kEach = 50;
  const auto domain = fixture::openDomain();
  std::mutex mutex;
  std::multiset<double> planned;
  const PlanService dut = serve(domain, [&](const Asked& asked, Deadline until, std::stop_token stop) {
    {
      const std::scoped_lock lock(mutex);
      planned.insert(asked.request.start.x);
    }
    return echo(asked, until, std::move(stop));
  });
  std::atomic<int> right = 0;
  {
    std::vector<std::jthread> robots;
    for (int c = 0; c < kClients; ++c)
      robots.emplace_back([&, c] {
        PlanClient asker = client(domain);
        // Two clients share a robot's name, and so its partition.
        right += askMany(asker, "nao_" + std::to_string(c / 2), c * kEach, kEach);
      });
  }
  EXPECT_EQ(right, kClients * kEach);
  ASSERT_EQ(planned.size(), kClients * kEach);  // none twice, though requests are resent
  for (int i = 0; i < kClients * kEach; ++i) EXPECT_EQ(planned.count(i), 1U) << i;
}

TEST(PlanService, moreRobotsThanItHasRoomForAllGetAnswers) {
  const auto domain = fixture::openDomain();
  const PlanService dut = serve(domain, echo, {.most_robots = 2});
  PlanClient asker = client(domain);
  for (int i = 0; i < 7; ++i) EXPECT_EQ(askMany(asker, "nao_" + std::to_string(i % 5), i, 1), 1) << i;
}

TEST(PlanService, stoppingCancelsWhatIsBeingPlanned) {
  constexpr int kClients = 4;
  const auto domain = fixture::openDomain();
  std::latch started(kClients);
  PlanService dut = serve(domain,
                          [&](const Asked&, Deadline, std::stop_token stop) {
                            started.count_down();
                            return untilStopped(std::move(stop));
                          },
                          {.threads = kClients});
  std::atomic<int> cancelled = 0;
  {
    std::vector<std::jthread> robots;
    for (int c = 0; c < kClients; ++c)
      robots.emplace_back([&, c] {
        PlanClient asker = client(domain);
        Question question = fixture::question("nao_" + std::to_string(c));
        question.deadline = milliseconds(600'000);
        cancelled += codeOf(asker.ask(question, kPatience)) == ErrorCode::kCancelled ? 1 : 0;
      });
    started.wait();
    dut.stop();
    EXPECT_TRUE(dut.wait().has_value());
  }
  EXPECT_EQ(cancelled, kClients);
}

TEST(PlanService, endsAtOnceWhenNothingIsAsked) {
  const auto domain = fixture::openDomain();
  PlanService dut = serve(domain, echo);
  dut.stop();
  EXPECT_TRUE(dut.wait().has_value());
  dut.stop();
}

TEST(PlanService, refusesWhatTheWireCannotCarry) {
  Served served = fixture::served();
  served.robot.modes[0].name = std::string(65, 'a');
  const Expected<PlanService> dut = PlanService::start(fixture::openDomain(), served, echo);
  ASSERT_FALSE(dut);
  EXPECT_EQ(dut.error().code, ErrorCode::kInvalidRobot);
}

TEST(PlanClient, saysWhenThereIsNoServer) {
  const auto domain = fixture::openDomain();
  Expected<PlanClient> dut = PlanClient::open(domain, {.discovery = milliseconds(200)});
  ASSERT_TRUE(dut) << dut.error().message;
  const Expected<PlanDocument> document = dut->ask(fixture::question(), kPatience);
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::kNoServer);
  EXPECT_NE(document.error().message.find(std::to_string(domain->id())), std::string::npos);
}

TEST(PlanClient, saysWhenTheServerDoesNotAnswerInTime) {
  const auto domain = fixture::openDomain();
  const PlanService service = serve(
      domain, [](const Asked&, Deadline, std::stop_token stop) { return untilStopped(std::move(stop)); });
  PlanClient dut = client(domain);
  const Expected<PlanDocument> document = dut.ask(fixture::question(), seconds(2));
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::kTimeout);
}

TEST(PlanClient, goesOnWithAServerThatComesBack) {
  const auto domain = fixture::openDomain();
  PlanClient dut = client(domain);
  for (int i = 0; i < 2; ++i) {
    const PlanService service = serve(domain, echo);
    EXPECT_EQ(askMany(dut, "nao_1", i, 1), 1) << i;
  }
}

/// The asker in the other process: 0 if all of its replies were right.
int askFromHere(std::uint32_t domain_id) {
  const auto domain = Domain::open({.id = domain_id, .use_network = false});
  if (!domain) return 2;
  Expected<PlanClient> asker = PlanClient::open(*domain, {.discovery = kPatience});
  return asker && askMany(*asker, "nao_1", 0, 20) == 20 ? 0 : 1;
}

TEST(PlanClient, mayBeInAnotherProcess) {
  const std::uint32_t domain_id = test::testDomain();
  const pid_t child = fork();  // before this process has threads
  ASSERT_GE(child, 0);
  if (child == 0) _exit(askFromHere(domain_id));
  const PlanService service = serve(fixture::openDomain(), echo);
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(Domain, isOpenedOnceInAProcessAndMayBeOpenedAgainLater) {
  {
    const auto domain = fixture::openDomain();
    const auto second = Domain::open({.id = domain->id(), .use_network = false});
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("already open"), std::string::npos) << second.error().message;
  }
  EXPECT_NE(fixture::openDomain(), nullptr);
}

TEST(Domain, refusesAnIdThatDoesNotExist) {
  const auto domain = Domain::open({.id = Domain::kLargestId + 1, .use_network = false});
  ASSERT_FALSE(domain);
  EXPECT_EQ(domain.error().code, ErrorCode::kInvalidRequest);
}

TEST(Domain, refusesAConfigurationThatCycloneDoesNotUnderstand) {
  setenv("CYCLONEDDS_URI", "<CycloneDDS><Domain><NoSuchThing>1</NoSuchThing></Domain></CycloneDDS>", 1);
  const auto domain = Domain::open({.id = 1, .use_network = false});
  unsetenv("CYCLONEDDS_URI");
  ASSERT_FALSE(domain);
  EXPECT_NE(domain.error().message.find("CYCLONEDDS_URI"), std::string::npos) << domain.error().message;
}

}  // namespace
}  // namespace underway
