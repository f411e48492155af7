#include "planner/plan_document.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace underway {
namespace {

using Json = nlohmann::ordered_json;

Robot makeRobot() {
  Robot robot;
  robot.name = "nao";
  for (const char* mode : {"frontal", "lateral", "crawl"}) robot.modes.emplace_back().name = mode;
  robot.switches.push_back(
      {.from = 0, .to = 2, .duration_s = 8.0, .displacement = {0.3, 0.0, 0.0}, .body_m = {}});
  return robot;
}

/// Documents of every shape, with numbers that use all their bits. Not sound plans: reading does not judge.
class RandomDocuments {
 public:
  explicit RandomDocuments(unsigned seed) : random_(seed) {}

  PlanDocument next() {
    PlanDocument document;
    document.robot_name = "nao";
    document.mode_names = {"frontal", "lateral", "crawl"};
    document.map_name = pick(2) ? "scenario3" : "quote \" slash \\ umlaut \xC3\xA4";
    document.revision = random_();
    document.world_hash = "0123456789abcdef";
    document.robot_hash = "fedcba9876543210";
    document.seed = random_();
    document.request = {pose(), mode(),          {number(), number()},    {},
                        mode(), Policy(pick(3)), 1.0 + std::abs(number())};
    if (pick(2)) document.request.goal_yaw = number();
    for (unsigned i = pick(3) == 0 ? pick(4) : 0; i > 0; --i) {
      document.request.other_goals.push_back({{number(), number()}, {}, mode()});
      if (pick(2)) document.request.other_goals.back().yaw = number();
    }
    if (pick(4) == 0) {
      document.answer = tl::unexpected(failure());
      return document;
    }
    document.answer = plan(document.request.start);
    document.answer->goal_index = pick(1 + static_cast<unsigned>(document.request.other_goals.size()));
    if (pick(5) == 0) document.choice = Choice{pick(2) == 0, "the plan still holds"};
    return document;
  }

 private:
  unsigned pick(unsigned count) { return static_cast<unsigned>(random_() % count); }
  double number() { return std::uniform_real_distribution<>(-100.0, 100.0)(random_); }
  Pose pose() { return {number(), number(), number()}; }
  ModeId mode() { return static_cast<ModeId>(pick(3)); }

  Error failure() {
    Error error{ErrorCode(pick(kErrorCodeCount)), "no way", {}};
    for (unsigned i = pick(3); i > 0; --i)
      error.blocking.push_back({"table", "crawl", "height", number(), number()});
    return error;
  }

  Plan plan(const Pose& start) {
    Plan result{{}, number(), number(), start, {random_(), random_(), 7, number(), number(), number()}};
    for (unsigned i = pick(5); i > 0; --i) {
      const ModeId in = mode();
      Motion motion{MotionKind(pick(3)), in, in, Sense::kForward, pose(), pose(), 0.0};
      if (motion.kind == MotionKind::kTranslate) motion.sense = kSenses[pick(4)];
      if (motion.kind == MotionKind::kSwitch) motion.to_mode = mode();
      if (motion.kind == MotionKind::kTurn) motion.angle_rad = number();
      Segment segment{motion, std::abs(number()), {number(), {}, {}}};
      if (pick(2)) segment.closeness.nearest = Nearest{"leg", {number(), number()}};
      if (pick(2)) segment.closeness.headroom_m = number();
      result.segments.push_back(segment);
      result.goal = motion.to;
    }
    return result;
  }

  std::mt19937_64 random_;
};

/// A plan of one translation, one turn and one switch, as JSON to be spoilt.
Json makePlanJson() {
  const Robot robot = makeRobot();
  PlanDocument document{Request(), "nao", {"frontal", "lateral", "crawl"}, "room", 1, "w", "r", 1, Plan{}};
  const Motion walk = translate(0, Sense::kForward, {0.6, 2.0, 0.0}, 1.5);
  const Motion about = turn(0, walk.to, 0.5, 0.5);
  document.answer->segments = {{walk, 22.0, {0.1, Nearest{"wall", {1.0, 2.5}}, 0.2}},
                               {about, 3.0, {0.1, {}, {}}},
                               {switchModes(robot.switches[0], about.to), 8.0, {0.1, {}, {}}}};
  return Json::parse(toJson(document));
}

std::string messageOf(const Json& json) {
  const auto document = planFromJson(json.dump(), makeRobot());
  return document ? "read" : document.error().message;
}

std::string keysOf(const Json& json) {
  std::string keys;
  for (const auto& item : json.items()) keys += (keys.empty() ? "" : " ") + item.key();
  return keys;
}

TEST(PlanDocument, RandomDocumentsRoundTripBitForBit) {
  RandomDocuments documents(1);
  for (int i = 0; i < 2000; ++i) {
    const PlanDocument document = documents.next();
    const auto again = planFromJson(toJson(document), makeRobot());
    ASSERT_TRUE(again) << again.error().message << "\n" << toJson(document);
    ASSERT_EQ(toJson(*again), toJson(document));
    ASSERT_EQ(again->request.start, document.request.start);
    ASSERT_EQ(goalsOf(again->request), goalsOf(document.request));
    ASSERT_EQ(again->answer.has_value(), document.answer.has_value());
    if (!document.answer) continue;
    ASSERT_EQ(again->answer->goal, document.answer->goal);
    ASSERT_EQ(again->answer->segments.size(), document.answer->segments.size());
    for (std::size_t k = 0; k < document.answer->segments.size(); ++k)
      ASSERT_EQ(again->answer->segments[k].motion, document.answer->segments[k].motion);
  }
}

TEST(PlanDocument, KeysComeInTheOrderOfTheFormat) {
  const Json json = makePlanJson();
  EXPECT_EQ(keysOf(json),
            "status message policy max_detour robot map revision world_hash robot_hash seed start "
            "start_mode goal "
            "goal_mode total_time_s length_m segments stats");
  EXPECT_EQ(keysOf(json["segments"][0]), "kind mode sense from to duration_s clearance_m headroom_m nearest");
  EXPECT_EQ(keysOf(json["segments"][1]),
            "kind mode angle_rad from to duration_s clearance_m headroom_m nearest");
  EXPECT_EQ(keysOf(json["segments"][2]),
            "kind mode to_mode from to duration_s clearance_m headroom_m nearest");
  EXPECT_TRUE(json["goal"]["yaw"].is_null());
  EXPECT_TRUE(json["segments"][1]["nearest"].is_null());
}

TEST(PlanDocument, AFailureIsWrittenWithItsCodeItsSentenceAndWhatBlocks) {
  PlanDocument document{Request(), "nao", {"frontal"}, "room", 1, "w", "r", 1, Plan{}};
  Error error{
      ErrorCode::kNoPathExists, "the table is too low", {{"table_top", "crawl", "height", 0.21, 0.19}}};
  document.answer = tl::unexpected(error);
  const Json json = Json::parse(toJson(document));
  EXPECT_EQ(json["status"], "no_path_exists");
  EXPECT_EQ(json["message"], "the table is too low");
  EXPECT_EQ(json["segments"], Json::array());
  EXPECT_EQ(json["blocking"].dump(),
            R"([{"obstacle":"table_top","mode":"crawl","of":"height","needs_m":0.21,"has_m":0.19}])");
}

TEST(PlanDocument, AFailureMayNameAModeThatTheRobotDoesNotHave) {
  PlanDocument document{Request(), "nao", {"flying"}, "room", 1, "w", "r", 1, Plan{}};
  document.answer = fail(ErrorCode::kInvalidRequest, "mode \"flying\" is not known");
  const auto again = planFromJson(toJson(document), makeRobot());
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(toJson(*again), toJson(document));
}

TEST(PlanDocument, BytesThatAreNoTextDoNotStopTheWriter) {
  PlanDocument document{Request(), "nao", {"frontal"}, "room \xFF", 1, "w", "r", 1, Plan{}};
  EXPECT_EQ(Json::parse(toJson(document))["map"], "room \xEF\xBF\xBD");
}

TEST(PlanDocument, ANumberThatIsNotFiniteIsNeverWrittenAndNeverRead) {
  PlanDocument document{Request(), "nao", {"frontal"}, "room", 1, "w", "r", 1, Plan{}};
  document.answer->total_time_s = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(Json::parse(toJson(document))["total_time_s"].is_null());
  const auto again = planFromJson(toJson(document), makeRobot());
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().message, "the plan cannot be read: total_time_s must be a finite number");
}

TEST(PlanDocument, EachFaultIsOneSentenceWithItsPath) {
  struct Case {
    const char* pointer;
    Json value;
    const char* says;
  };
  const std::vector<Case> cases = {
      {"/segments/2/from/x", "far", "segments[2].from.x must be a finite number"},
      {"/segments/0/from/yaw", nullptr, "segments[0].from.yaw must be a finite number"},
      {"/segments/0/to/x", 1e6, "segments[0].to.x must be between -100000.0 and 100000.0"},
      {"/segments/1/mode", "flying", "segments[1].mode is \"flying\", which is no mode of robot \"nao\""},
      {"/segments/2/to_mode", "swim", "segments[2].to_mode is \"swim\", which is no mode of robot \"nao\""},
      {"/segments/0/sense", "up", "segments[0].sense is \"up\", which is no sense"},
      {"/segments/0/kind", "jump", "segments[0].kind is \"jump\", which is no kind of segment"},
      {"/segments/0/nearest", 3, "segments[0].nearest must be an object"},
      {"/segments/1", Json::array(), "segments[1] must be an object"},
      {"/segments", "none", "segments must be an array"},
      {"/policy", "cheapest", "policy is \"cheapest\", which is no policy"},
      {"/status", "fine", "is \"fine\", which is no status"},
      {"/revision", -1, "revision must be a whole number"},
      {"/stats/batches", 5'000'000'000, "stats.batches must be a whole number between 0 and 4294967295"},
      {"/map", 7, "map must be a text"},
      {"/goal", 7, "goal must be an object"},
  };
  for (const Case& c : cases) {
    Json json = makePlanJson();
    json[Json::json_pointer(c.pointer)] = c.value;
    EXPECT_NE(messageOf(json).find(c.says), std::string::npos) << messageOf(json) << "\nwanted: " << c.says;
  }
}

TEST(PlanDocument, OfSeveralGoalsItSaysWhichOneThePlanLeadsTo) {
  PlanDocument document{Request(), "nao", {"frontal"}, "room", 1, "w", "r", 1, Plan{}};
  document.request.other_goals = {{{5.4, 2.0}, 0.5}};
  document.answer->goal_index = 1;
  const Json json = Json::parse(toJson(document));
  EXPECT_EQ(json["goal"].dump(), R"({"x":5.4,"y":2.0,"yaw":0.5})");
  EXPECT_EQ(json["goal_index"], 1);
  EXPECT_EQ(json["goals"][0].dump(), R"({"x":0.0,"y":0.0,"yaw":null,"mode":"frontal"})");
  EXPECT_EQ(messageOf(json), "read");

  const auto spoilt = [&](const char* pointer, const Json& value) {
    Json changed = json;
    changed[Json::json_pointer(pointer)] = value;
    return messageOf(changed);
  };
  EXPECT_NE(spoilt("/goals", Json::array()).find("goals must hold one goal at least"), std::string::npos);
  EXPECT_NE(spoilt("/goal_index", 0).find("goal is not the goal of that index"), std::string::npos);
  EXPECT_NE(spoilt("/goal_index", 2).find("goal_index must be a whole number between 0 and 1"),
            std::string::npos);
  EXPECT_NE(spoilt("/goals", Json(std::vector<Json>(65, json["goals"][0]))).find("at most 64"),
            std::string::npos);
}

TEST(PlanDocument, OfAPlanThatWasReplannedItSaysWhetherItIsNewAndWhy) {
  PlanDocument document{Request(), "nao", {"frontal"}, "room", 1, "w", "r", 1, Plan{}};
  document.choice = Choice{false, "the plan still holds"};
  const Json json = Json::parse(toJson(document));
  EXPECT_EQ(json["is_new"], false);
  EXPECT_EQ(json["message"], "the plan still holds");
  const auto again = planFromJson(json.dump(), makeRobot());
  ASSERT_TRUE(again && again->choice);
  EXPECT_EQ(again->choice->why, "the plan still holds");
}

TEST(PlanDocument, EveryFieldButTheDetourIsNeeded) {
  const Json whole = makePlanJson();
  for (const auto& item : whole.items()) {
    Json json = whole;
    json.erase(item.key());
    const std::string wanted = item.key() == "max_detour" ? "read" : item.key() + " is missing";
    EXPECT_NE(messageOf(json).find(wanted), std::string::npos) << messageOf(json);
  }
  for (const auto& item : whole["segments"][2].items()) {
    Json json = whole;
    json["segments"][2].erase(item.key());
    EXPECT_NE(messageOf(json).find("segments[2]." + item.key() + " is missing"), std::string::npos);
  }
}

TEST(PlanDocument, NoLimitOfDetourIsKept) {
  PlanDocument document{Request(), "nao", {"frontal"}, "room", 1, "w", "r", 1, Plan{}};
  document.request.max_detour = std::numeric_limits<double>::infinity();
  const auto again = planFromJson(toJson(document), makeRobot());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->request.max_detour, std::numeric_limits<double>::infinity());
}

TEST(PlanDocument, TextThatIsNoJsonIsRefusedWithItsLine) {
  const auto broken = planFromJson("{\n\"status\": \"ok\",\n oops", makeRobot());
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.error().message.find("line 3"), std::string::npos) << broken.error().message;
  EXPECT_FALSE(planFromJson("", makeRobot()));
  EXPECT_FALSE(planFromJson("[]", makeRobot()));
  EXPECT_FALSE(planFromJson("{\"revision\": 1e999}", makeRobot()));
  EXPECT_FALSE(planFromJson(std::string(1'000'000, '['), makeRobot()));
}

TEST(PlanDocument, SpoiltTextIsReadOrRefusedAndWhatIsReadCanBeWritten) {
  std::mt19937_64 random(2);
  const std::string text = makePlanJson().dump(1);
  int refused = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string spoilt = text;
    for (auto k = 1 + random() % 3; k > 0 && !spoilt.empty(); --k) {
      const std::size_t at = random() % spoilt.size();
      switch (random() % 4) {
        case 0:
          spoilt[at] = static_cast<char>(random());
          break;
        case 1:
          spoilt.erase(at, 1 + random() % 20);
          break;
        case 2:
          spoilt.insert(at, spoilt.substr(random() % spoilt.size(), random() % 20));
          break;
        default:
          spoilt.resize(at);
          break;
      }
    }
    const auto document = planFromJson(spoilt, makeRobot());
    if (document) {
      EXPECT_TRUE(planFromJson(toJson(*document), makeRobot())) << spoilt;
    } else {
      ++refused;
      EXPECT_EQ(document.error().code, ErrorCode::kInvalidRequest);
      EXPECT_FALSE(document.error().message.empty());
    }
  }
  EXPECT_GT(refused, 2500);
}

}  // namespace
}  // namespace underway
