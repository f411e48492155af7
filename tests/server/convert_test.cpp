#include "server/convert.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <utility>

#include "server/wire_limits.hpp"
#include "tests/server/plan_fixture.hpp"

namespace underway {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Which holds nothing that has to be freed.
underway_PlanRequest goodRequest() { return **toWire({{1, 2, 3}, 9}, fixture::question()); }

/// With other goals and a plan that is being followed.
Question questionWithEverything() {
  Question question = fixture::question();
  question.other_goals = {{{1.5, 0.5}, {}, ""}, {{2.5, 1.0 / 7.0}, -0.0, "lateral"}};
  question.purpose = Purpose::kReplan;
  question.followed = {{fixture::planWithEverything(), 1, 0.25}, {"frontal", "lateral", "crawl"}, 0.3, 4.0};
  return question;
}
WireRequest fullRequest() { return std::move(*toWire({{1, 2, 3}, 9}, questionWithEverything())); }

TEST(ConvertRequest, arrivesAsItWasAsked) {
  const Question question = fixture::question();
  const Expected<Received> received = fromWire(goodRequest(), fixture::served().robot);
  ASSERT_TRUE(received) << received.error().message;
  const Request& request = received->asked.request;
  EXPECT_EQ(request.start, question.start);
  EXPECT_TRUE(std::signbit(request.start.yaw));
  EXPECT_EQ(request.start_mode, 0);
  EXPECT_EQ(request.goal, question.goal);
  EXPECT_EQ(request.goal_yaw, question.goal_yaw);
  EXPECT_EQ(request.goal_mode, 2);
  EXPECT_EQ(request.policy, Policy::kSafest);
  EXPECT_EQ(request.max_detour, 2.5);
  EXPECT_EQ(received->deadline, question.deadline);
  EXPECT_EQ(idOf(goodRequest().id), (RequestId{{1, 2, 3}, 9}));
  EXPECT_EQ(partitionOf(goodRequest().robot), "nao_1");
}

TEST(ConvertRequest, emptyModesAndPolicyAreTheFirstAndAnyHeadingIsFree) {
  underway_PlanRequest wire = goodRequest();
  wire.start_mode[0] = wire.goal_mode[0] = wire.policy[0] = '\0';
  wire.has_goal_yaw = false;
  wire.goal_yaw_rad = kNan;
  wire.max_detour = kInfinity;
  const Expected<Received> received = fromWire(wire, fixture::served().robot);
  ASSERT_TRUE(received) << received.error().message;
  EXPECT_EQ(received->asked.request.start_mode, 0);
  EXPECT_EQ(received->asked.request.goal_mode, 0);
  EXPECT_EQ(received->asked.request.policy, Policy::kPriority);
  EXPECT_FALSE(received->asked.request.goal_yaw.has_value());
  EXPECT_EQ(received->asked.request.max_detour, kInfinity);
}

TEST(ConvertRequest, namesTheFieldThatIsWrong) {
  const std::pair<const char*, void (*)(underway_PlanRequest&)> cases[] = {
      {"robot", [](auto& wire) { std::strcpy(wire.robot, "a/b"); }},
      {"robot", [](auto& wire) { wire.robot[0] = '\0'; }},
      {"robot", [](auto& wire) { std::strcpy(wire.robot, "nao*"); }},
      {"robot", [](auto& wire) { std::memset(wire.robot, 'a', sizeof wire.robot); }},
      {"start.x_m", [](auto& wire) { wire.start.x_m = kNan; }},
      {"start.y_m", [](auto& wire) { wire.start.y_m = 100'001.0; }},
      {"start.yaw_rad", [](auto& wire) { wire.start.yaw_rad = kInfinity; }},
      {"goal_x_m", [](auto& wire) { wire.goal_x_m = -kInfinity; }},
      {"goal_y_m", [](auto& wire) { wire.goal_y_m = kNan; }},
      {"goal_yaw_rad", [](auto& wire) { wire.goal_yaw_rad = 1e9; }},
      {"has_goal_yaw", [](auto& wire) { std::memset(&wire.has_goal_yaw, 2, 1); }},
      {"start_mode", [](auto& wire) { std::strcpy(wire.start_mode, "hover"); }},
      {"start_mode", [](auto& wire) { std::memset(wire.start_mode, 'a', sizeof wire.start_mode); }},
      {"goal_mode", [](auto& wire) { std::strcpy(wire.goal_mode, "Crawl"); }},
      {"policy", [](auto& wire) { std::strcpy(wire.policy, "best"); }},
      {"policy", [](auto& wire) { std::memset(wire.policy, 'a', sizeof wire.policy); }},
      {"max_detour", [](auto& wire) { wire.max_detour = 0.99; }},
      {"max_detour", [](auto& wire) { wire.max_detour = kNan; }},
      {"deadline_ms", [](auto& wire) { wire.deadline_ms = -1; }},
      {"deadline_ms", [](auto& wire) { wire.deadline_ms = 0; }},
      {"deadline_ms", [](auto& wire) { wire.deadline_ms = 600'001; }},
  };
  for (const auto& [field, spoil] : cases) {
    underway_PlanRequest wire = goodRequest();
    spoil(wire);
    const Expected<Received> received = fromWire(wire, fixture::served().robot);
    ASSERT_FALSE(received) << field;
    EXPECT_EQ(received.error().code, ErrorCode::kInvalidRequest) << field;
    EXPECT_TRUE(received.error().message.starts_with(field)) << field << ": " << received.error().message;
  }
}

TEST(ConvertRequest, refusesToSendWhatTheWireCannotCarry) {
  const std::pair<const char*, void (*)(Question&)> cases[] = {
      {"robot", [](Question& question) { question.robot = "nao 1"; }},
      {"start_mode", [](Question& question) { question.start_mode = std::string(65, 'a'); }},
      {"goal_mode", [](Question& question) { question.goal_mode = std::string("a\0b", 3); }},
      {"deadline_ms", [](Question& question) { question.deadline = std::chrono::milliseconds::min(); }},
      {"deadline_ms", [](Question& question) { question.deadline = std::chrono::milliseconds::max(); }},
      {"start.x_m", [](Question& question) { question.start.x = kNan; }},
  };
  for (const auto& [field, spoil] : cases) {
    Question question = fixture::question();
    spoil(question);
    const Expected<WireRequest> wire = toWire({}, question);
    ASSERT_FALSE(wire) << field;
    EXPECT_EQ(wire.error().code, ErrorCode::kInvalidRequest) << field;
    EXPECT_NE(wire.error().message.find(field), std::string::npos) << wire.error().message;
  }
}

/// The law of request fuzzing: whatever the bytes, either a refusal that says why or a request within its
/// ranges.
TEST(ConvertRequest, survivesMutatedBytes) {
  std::mt19937 random(1);
  const Robot robot = fixture::served().robot;
  int accepted = 0;
  for (int round = 0; round < 20'000; ++round) {
    underway_PlanRequest wire = goodRequest();
    const std::span bytes(reinterpret_cast<unsigned char*>(&wire), sizeof wire);
    for (unsigned i = 0, changes = 1 + random() % 8; i < changes; ++i)
      bytes[random() % bytes.size()] = static_cast<unsigned char>(random());
    wire.other_goals = goodRequest().other_goals;  // pointers stay, for DDS itself makes them
    wire.following = goodRequest().following;
    const Expected<Received> received = fromWire(wire, robot);
    if (!received) {
      EXPECT_EQ(received.error().code, ErrorCode::kInvalidRequest);
      EXPECT_FALSE(received.error().message.empty());
      continue;
    }
    ++accepted;
    const Request& request = received->asked.request;
    for (const double value : {request.start.x, request.start.y, request.goal.x, request.goal.y})
      EXPECT_LE(std::abs(value), World::kLargest_m);
    EXPECT_LE(std::abs(request.start.yaw), 1000.0);
    EXPECT_LT(std::max(request.start_mode, request.goal_mode), robot.modes.size());
    EXPECT_GE(request.max_detour, 1.0);
    EXPECT_GE(received->deadline, std::chrono::milliseconds(1));
    EXPECT_TRUE(isRobotName(partitionOf(wire.robot)));
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_LT(accepted, 19'000);
}

TEST(ConvertRequest, otherGoalsAndThePlanThatIsFollowedArriveAsTheyWereAsked) {
  const Question question = questionWithEverything();
  Robot robot = fixture::served().robot;
  robot.modes[0].speed_mps.fill(0.05);
  const Expected<Received> received = fromWire(*fullRequest(), robot);
  ASSERT_TRUE(received) << received.error().message;
  const Asked& asked = received->asked;
  EXPECT_EQ(asked.request.other_goals, (std::vector<Goal>{{{1.5, 0.5}, {}, 0}, {{2.5, 1.0 / 7.0}, -0.0, 1}}));
  EXPECT_EQ(asked.purpose, Purpose::kReplan);
  EXPECT_EQ(asked.executing.segment, 1U);
  EXPECT_EQ(asked.executing.done, 0.25);
  EXPECT_EQ(asked.reluctance.share, 0.3);
  EXPECT_EQ(asked.reluctance.least_s, 4.0);
  const std::vector<Segment>& sent = question.followed.executing.plan.segments;
  ASSERT_EQ(asked.executing.plan.segments.size(), sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i)
    EXPECT_EQ(asked.executing.plan.segments[i].motion, sent[i].motion);
  EXPECT_EQ(asked.executing.plan.goal, question.followed.executing.plan.goal);
  EXPECT_NEAR(asked.executing.plan.segments[0].duration_s, 3.2 / 0.05,
              1e-9);  // the robot's, not the client's
}

TEST(ConvertRequest, modesOfThePlanThatIsFollowedAreToldByTheirNames) {
  Question question = questionWithEverything();
  question.followed.mode_names = {"crawl", "frontal", "lateral"};
  const auto wire = toWire({}, question);
  const Expected<Received> received = fromWire(**wire, fixture::served().robot);
  ASSERT_TRUE(received) << received.error().message;
  EXPECT_EQ(received->asked.executing.plan.segments[0].motion.mode, 2);
  EXPECT_EQ(received->asked.executing.plan.segments[2].motion.to_mode, 1);
}

TEST(ConvertRequest, namesTheFieldOfAPlanThatIsFollowedThatIsWrong) {
  const std::pair<const char*, void (*)(underway_PlanRequest&)> cases[] = {
      {"kind", [](auto& wire) { std::memset(&wire.kind, 7, 1); }},
      {"other_goals[1]", [](auto& wire) { wire.other_goals._buffer[1].x_m = kNan; }},
      {"other_goals[0]", [](auto& wire) { std::memset(&wire.other_goals._buffer[0].has_yaw, 2, 1); }},
      {"other_goals[1].mode", [](auto& wire) { std::strcpy(wire.other_goals._buffer[1].mode, "hover"); }},
      {"following.modes[2]", [](auto& wire) { std::strcpy(wire.following.modes._buffer[2], "hover"); }},
      {"following.step ", [](auto& wire) { wire.following.step = 4; }},
      {"following.done", [](auto& wire) { wire.following.done = kNan; }},
      {"following.least_gain ", [](auto& wire) { wire.following.least_gain = 1.5; }},
      {"following.least_gain_s", [](auto& wire) { wire.following.least_gain_s = -1.0; }},
      {"following.steps[0]", [](auto& wire) { wire.following.steps._buffer[0].from.x_m = 1e6; }},
      {"following.steps[1]", [](auto& wire) { wire.following.steps._buffer[1].angle_rad = kInfinity; }},
      {"following.steps[1]", [](auto& wire) { std::memset(&wire.following.steps._buffer[1].kind, 9, 1); }},
      {"following.steps[2]", [](auto& wire) { wire.following.steps._buffer[2].to_mode = 3; }},
  };
  for (const auto& [field, spoil] : cases) {
    const WireRequest wire = fullRequest();
    spoil(*wire);
    const Expected<Received> received = fromWire(*wire, fixture::served().robot);
    ASSERT_FALSE(received) << field;
    EXPECT_TRUE(received.error().message.starts_with(field)) << field << ": " << received.error().message;
  }
}

TEST(ConvertRequest, countsThatAreTooLargeOrNothingAreRefusedUnread) {
  const std::pair<const char*, std::uint32_t& (*)(underway_PlanRequest&)> counts[] = {
      {"other_goals", [](auto& wire) -> std::uint32_t& { return wire.other_goals._length; }},
      {"following.modes", [](auto& wire) -> std::uint32_t& { return wire.following.modes._length; }},
      {"following.steps", [](auto& wire) -> std::uint32_t& { return wire.following.steps._length; }},
  };
  for (const auto& [field, count] : counts) {
    for (const std::uint32_t wrong : {5000U, 4'000'000'000U, 0U}) {
      const WireRequest wire = fullRequest();
      const std::uint32_t right = std::exchange(count(*wire), wrong);
      const Expected<Received> received = fromWire(*wire, fixture::served().robot);
      count(*wire) = right;                                             // so that all of it is freed
      if (wrong == 0 && field == std::string("other_goals")) continue;  // that is all right
      ASSERT_FALSE(received) << field << " " << wrong;
      EXPECT_TRUE(received.error().message.starts_with(field)) << received.error().message;
    }
  }
}

TEST(ConvertRequest, sixtyFourGoalsAreSentAndNoMore) {
  Question question = fixture::question();
  question.other_goals.resize(63);
  EXPECT_TRUE(toWire({}, question));
  question.other_goals.resize(64);
  const auto wire = toWire({}, question);
  ASSERT_FALSE(wire);
  EXPECT_NE(wire.error().message.find("other_goals must be 63 at most"), std::string::npos);
}

TEST(ConvertReply, saysWhichGoalItLeadsToAndHowItWasChosen) {
  Question question = questionWithEverything();
  Plan plan = fixture::planWithEverything();
  plan.goal_index = 2;
  const WireReply wire = toWire({}, fixture::served(), Replanned{plan, false, "the plan still holds"});
  const Expected<PlanDocument> document = fromWire(*wire, question);
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(document->answer->goal_index, 2U);
  EXPECT_EQ(document->request.other_goals[1].mode, 1);
  ASSERT_TRUE(document->choice);
  EXPECT_FALSE(document->choice->is_new);
  EXPECT_EQ(document->choice->why, "the plan still holds");
  wire->goal_index = 3;
  EXPECT_FALSE(fromWire(*wire, question));
}

TEST(ConvertReply, aPlanArrivesBitForBit) {
  const Question question = fixture::question();
  const Served served = fixture::served();
  const WireReply wire = toWire({}, served, fixture::planWithEverything());
  const Expected<PlanDocument> document = fromWire(*wire, question);
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(toJson(*document), toJson(fixture::documentFor(question, served, fixture::planWithEverything())));
  ASSERT_TRUE(document->answer);
  const std::vector<Segment> expected = fixture::planWithEverything().segments;
  ASSERT_EQ(document->answer->segments.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(document->answer->segments[i].motion, expected[i].motion);
    EXPECT_EQ(document->answer->segments[i].closeness.headroom_m, expected[i].closeness.headroom_m);
  }
  EXPECT_TRUE(std::signbit(document->answer->segments[0].motion.from.yaw));
}

TEST(ConvertReply, everyFailureArrivesWithWhatBlocks) {
  const Question question = fixture::question();
  for (int code = 0; code < kErrorCodeCount; ++code) {
    const Error error{
        static_cast<ErrorCode>(code), "no way \xC3\xA9", {{"table", "crawl", "height", 0.21, 0.19}}, 3, "ff"};
    const WireReply wire = toWire({}, fixture::served(), tl::unexpected(error));
    const Expected<PlanDocument> document = fromWire(*wire, question);
    ASSERT_TRUE(document) << document.error().message;
    EXPECT_EQ(toJson(*document),
              toJson(fixture::documentFor(question, fixture::served(), tl::unexpected(error))));
  }
}

TEST(ConvertReply, aPlanThatMustNotBeSentBecomesAnError) {
  const std::pair<const char*, void (*)(Plan&)> cases[] = {
      {"segments", [](Plan& plan) { plan.segments.resize(kMostSegments + 1); }},
      {"motion", [](Plan& plan) { plan.segments[1].motion.to.yaw = kNan; }},
      {"duration", [](Plan& plan) { plan.segments[0].duration_s = kInfinity; }},
      {"clearance", [](Plan& plan) { plan.segments[0].closeness.clearance_m = -0.1; }},
      {"mode", [](Plan& plan) { plan.segments[2].motion.to_mode = 3; }},
      {"obstacle id", [](Plan& plan) { plan.segments[0].closeness.nearest->id = std::string(4097, 'a'); }},
      {"goal", [](Plan& plan) { plan.goal.x = kNan; }},
      {"statistics", [](Plan& plan) { plan.stats.query_us = kNan; }},
      {"time", [](Plan& plan) { plan.total_time_s = -1.0; }},
  };
  for (const auto& [word, spoil] : cases) {
    Plan plan = fixture::planWithEverything();
    spoil(plan);
    const WireReply wire = toWire({}, fixture::served(), plan);
    EXPECT_FALSE(wire->ok) << word;
    EXPECT_EQ(wire->code, underway_INTERNAL) << word;
    EXPECT_NE(std::string(wire->message).find(word), std::string::npos) << wire->message;
  }
}

TEST(ConvertReply, longTextsAreCutBetweenCharacters) {
  std::string text = "a";
  while (text.size() <= kLongestText) text += "\xC3\xA9";
  const Error error{ErrorCode::kTimeout, text,
                    std::vector<Blocking>(100, {text, "crawl", "width", kNan, 0.0})};
  const WireReply wire = toWire({}, fixture::served(), tl::unexpected(error));
  EXPECT_EQ(std::strlen(wire->message), kLongestText - 1);
  EXPECT_EQ(wire->blocking._length, 0U);  // a number that is not finite is nothing to say
}

TEST(ConvertReply, anUnknownModeComesBackAsTheServersRefusal) {
  Question question = fixture::question();
  question.goal_mode = "hover";
  const WireReply wire =
      toWire({}, fixture::served(), fail(ErrorCode::kInvalidRequest, "goal_mode is not a mode of robot nao"));
  const Expected<PlanDocument> document = fromWire(*wire, question);
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::kInvalidRequest);
  EXPECT_EQ(document.error().message, "goal_mode is not a mode of robot nao");
}

/// Counts, flags, enumerators and numbers at random; pointers stay, for DDS itself makes them.
TEST(ConvertReply, survivesMutatedReplies) {
  std::mt19937 random(2);
  const auto below = [&random](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  const auto spoil = [&random](void* field, std::size_t size) {
    static_cast<unsigned char*>(field)[random() % size] = static_cast<unsigned char>(random());
  };
  int refused = 0;
  for (int round = 0; round < 20'000; ++round) {
    const WireReply wire = toWire({}, fixture::served(), fixture::planWithEverything());
    const std::uint32_t segments = wire->segments._length;
    const std::uint32_t modes = wire->modes._length;
    underway_Segment& segment = wire->segments._buffer[random() % segments];
    for (unsigned i = 0, changes = 1 + random() % 4; i < changes; ++i) {
      switch (random() % 10) {
        case 0:
          spoil(&segment.kind, sizeof segment.kind);
          break;
        case 1:
          spoil(&segment.sense, sizeof segment.sense);
          break;
        case 2:
          spoil(&segment.mode, 1);
          break;
        case 3:
          spoil(&segment.from, sizeof segment.from);
          break;
        case 4:
          spoil(&segment.has_nearest, 1);
          break;
        case 5:
          spoil(&segment.clearance_m, sizeof segment.clearance_m);
          break;
        case 6:
          spoil(&wire->ok, 1);
          break;
        case 7:
          wire->segments._length = below(2) == 0 ? below(segments) : 4097 + below(99);
          break;
        case 8:
          wire->modes._length = below(2) == 0 ? below(modes) : 17 + below(9999);
          break;
        default:
          spoil(wire->modes._buffer[0], std::strlen(wire->modes._buffer[0]));
          break;
      }
    }
    const Expected<PlanDocument> document = fromWire(*wire, fixture::question());
    wire->segments._length = segments;  // so that all of it is freed
    wire->modes._length = modes;
    refused += document ? 0 : 1;
    if (!document || !document->answer) continue;
    EXPECT_EQ(faultOf(*document->answer, document->mode_names.size()), "");
  }
  EXPECT_GT(refused, 1000);
  EXPECT_LT(refused, 19'000);
}

TEST(ConvertServed, whatTheWireCannotCarryIsSaid) {
  EXPECT_EQ(faultOf(fixture::served()), "");
  Served no_modes = fixture::served();
  no_modes.robot.modes.clear();
  EXPECT_NE(faultOf(no_modes), "");
  Served long_mode = fixture::served();
  long_mode.robot.modes[1].name = std::string(65, 'a');
  EXPECT_NE(faultOf(long_mode), "");
  Served long_map = fixture::served();
  long_map.map_name = std::string(4097, 'a');
  EXPECT_NE(faultOf(long_map), "");
}

}  // namespace
}  // namespace underway
