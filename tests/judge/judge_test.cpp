#include "tests/judge/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace judge {
namespace {

using Json = nlohmann::json;

constexpr double kQuarter = 1.5707963267948966;

/// A 6 x 4 m room with a post beside the way and a low table across it, and NAO's three modes.
Scene room() {
  Scene scene;
  scene.name = "room";
  scene.bounds = placed(Pose{}, Rect{0.0, 6.0, 0.0, 4.0});
  scene.boxes = {{"post", {1.5, 1.5, 0.5}, {0.2, 0.2, 1.0}, {}},
                 {"table", {4.0, 2.0, 0.5}, {0.4, 3.0, 0.4}, {}}};
  return scene;
}

/// NAO's modes in rounder numbers.
RobotFile robot() { return readRobotFile(std::string(UNDERWAY_SOURCE_DIR) + "/tests/judge/robot.yaml"); }

Json pose(double x, double y, double yaw) { return {{"x", x}, {"y", y}, {"yaw", yaw}}; }

Json segment(const std::string& kind, const std::string& mode, const Json& from, const Json& to,
             double duration_s) {
  return {{"kind", kind},
          {"mode", mode},
          {"from", from},
          {"to", to},
          {"duration_s", duration_s},
          {"clearance_m", 1.0},
          {"headroom_m", nullptr},
          {"nearest", nullptr}};
}

Json nearest(const std::string& id, double x, double y) { return {{"id", id}, {"x", x}, {"y", y}}; }

Json withTotals(Json plan) {
  double time_s = 0.0;
  double length_m = 0.0;
  for (const Json& part : plan["segments"]) {
    time_s += part["duration_s"].get<double>();
    if (part["kind"] == "translate")
      length_m += std::hypot(part["to"]["x"].get<double>() - part["from"]["x"].get<double>(),
                             part["to"]["y"].get<double>() - part["from"]["y"].get<double>());
  }
  plan["total_time_s"] = time_s;
  plan["length_m"] = length_m;
  return plan;
}

/// Walk past the post, lie down, crawl under the table, stand up, turn, sidestep. Every number is worked out
/// by hand:
/// - the post's top edge is y = 1.6, the walking body's lower side y = 1.805: 0.205 m at (1.4..1.6, 1.6);
/// - the table's edge is x = 3.8; lying down at x = 2.8 reaches to 3.46: 0.34 m;
/// - crawling sees nothing within 1 m but the post, from its tail at 2.8: hypot(1.2, 0.205) is more than 1 m;
///   the table's underside is 0.30 m, the crawl 0.21 m high: headroom 0.09 m;
/// - standing up at 4.7 begins at 4.4: 0.2 m from the table's edge at 4.2;
/// - standing at 4.8 has its back at 4.67, 0.47 m away; turning puts a corner at most hypot(.13, .195) back,
/// when it
///   points straight at the table: 0.6 - hypot(.13, .195);
/// - turned left its right side is x = 4.8 + 0.195, its left x = 4.8 - 0.195: 0.405 m; moving right leaves it
/// there.
Json goodPlan() {
  const double corner = std::hypot(0.13, 0.195);
  Json walk = segment("translate", "frontal", pose(0.6, 2.0, 0.0), pose(2.8, 2.0, 0.0), 2.2 / 0.068);
  walk["sense"] = "forward";
  walk["clearance_m"] = 0.205;
  walk["nearest"] = nearest("post", 1.5, 1.6);
  Json down = segment("switch", "frontal", pose(2.8, 2.0, 0.0), pose(3.1, 2.0, 0.0), 8.0);
  down["to_mode"] = "crawl";
  down["clearance_m"] = 0.34;
  down["nearest"] = nearest("table", 3.8, 2.0);
  Json crawl = segment("translate", "crawl", pose(3.1, 2.0, 0.0), pose(4.7, 2.0, 0.0), 1.6 / 0.025);
  crawl["sense"] = "forward";
  crawl["headroom_m"] = 0.3 - 0.21;
  Json up = segment("switch", "crawl", pose(4.7, 2.0, 0.0), pose(4.8, 2.0, 0.0), 12.0);
  up["to_mode"] = "frontal";
  up["clearance_m"] = 0.2;
  up["nearest"] = nearest("table", 4.2, 2.0);
  Json turn = segment("turn", "frontal", pose(4.8, 2.0, 0.0), pose(4.8, 2.0, kQuarter), kQuarter / 0.17);
  turn["angle_rad"] = kQuarter;
  turn["clearance_m"] = 0.6 - corner;
  turn["nearest"] = nearest("table", 4.2, 2.0);
  Json change = segment("switch", "frontal", pose(4.8, 2.0, kQuarter), pose(4.8, 2.0, kQuarter), 0.0);
  change["to_mode"] = "lateral";
  change["clearance_m"] = 0.405;
  change["nearest"] = nearest("table", 4.2, 2.0);
  Json side = segment("translate", "lateral", pose(4.8, 2.0, kQuarter), pose(5.3, 2.0, kQuarter), 0.5 / 0.04);
  side["sense"] = "right";
  side["clearance_m"] = 0.405;
  side["nearest"] = nearest("table", 4.2, 2.0);
  return withTotals({{"status", "ok"},
                     {"message", ""},
                     {"policy", "priority"},
                     {"robot", "round"},
                     {"map", "room"},
                     {"revision", 1},
                     {"world_hash", "a"},
                     {"robot_hash", "b"},
                     {"seed", 1},
                     {"start", pose(0.6, 2.0, 0.0)},
                     {"start_mode", "frontal"},
                     {"goal", pose(5.3, 2.0, kQuarter)},
                     {"goal_mode", "lateral"},
                     {"segments", {walk, down, crawl, up, turn, change, side}},
                     {"stats",
                      {{"nodes", 1},
                       {"edges", 1},
                       {"batches", 1},
                       {"build_ms", 0.5},
                       {"query_us", 0.5},
                       {"certify_us", 0.5}}}});
}

enum Part { kWalk, kDown, kCrawl, kUp, kTurn, kChange, kSide };

Verdict judged(const Json& plan, const Scene& scene = room()) {
  return judgePlan(plan.dump(), scene, robot());
}

std::string said(const Verdict& verdict) {
  std::string text;
  for (const std::string& violation : verdict.violations) text += violation + "\n";
  return text;
}

TEST(Judge, FindsNothingWrongWithAGoodPlan) { EXPECT_EQ(said(judged(goodPlan())), ""); }

TEST(Judge, TakesAGoalWithoutYawAtAnyHeading) {
  Json plan = goodPlan();
  plan["goal"]["yaw"] = nullptr;
  EXPECT_EQ(said(judged(plan)), "");
}

TEST(Judge, TakesAClearanceUpToOneMillimetreBelowTheTruth) {
  Json plan = goodPlan();
  plan["segments"][kWalk]["clearance_m"] = 0.2041;
  EXPECT_EQ(said(judged(plan)), "");
}

/// A good plan with one thing broken, and what the judge must say of it.
struct Broken {
  const char* name;
  std::function<void(Json&)> breaks;
  const char* sentence;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

class JudgeOfBrokenPlans : public testing::TestWithParam<Broken> {};

TEST_P(JudgeOfBrokenPlans, NamesWhatIsWrong) {
  Json plan = goodPlan();
  GetParam().breaks(plan);
  const std::string text = said(judged(plan));
  EXPECT_NE(text.find(GetParam().sentence), std::string::npos) << "said:\n" << text;
}

Json& at(Json& plan, Part part) { return plan["segments"][part]; }

const std::vector<Broken> kForm{
    {"MissingKey", [](Json& plan) { plan.erase("world_hash"); }, "lacks the key \"world_hash\""},
    {"TextForANumber", [](Json& plan) { plan["total_time_s"] = "long"; }, "\"total_time_s\" is not a number"},
    {"NegativeRevision", [](Json& plan) { plan["revision"] = -1; }, "not a whole number"},
    {"NullClearance", [](Json& plan) { at(plan, kWalk)["clearance_m"] = nullptr; }, "is not a number"},
    {"UnknownKind", [](Json& plan) { at(plan, kWalk)["kind"] = "fly"; },
     "\"fly\", which the format does not know"},
    {"UnknownStatus", [](Json& plan) { plan["status"] = "fine"; },
     "\"fine\", which the format does not know"},
    {"UnknownPolicy", [](Json& plan) { plan["policy"] = "best"; },
     "\"best\", which the format does not know"},
    {"SegmentsNoList", [](Json& plan) { plan["segments"] = 3; }, "is not a list"},
    {"OtherRobot", [](Json& plan) { plan["robot"] = "atlas"; }, "is of robot atlas"},
    {"OtherMap", [](Json& plan) { plan["map"] = "hall"; }, "is of map hall"},
    {"UnknownMode", [](Json& plan) { at(plan, kWalk)["mode"] = "fly"; }, "the robot has no mode fly"},
    {"RefusalWithSegments", [](Json& plan) { plan["status"] = "timeout", plan["blocking"] = Json::array(); },
     "says no and has segments"},
    {"RefusalWithoutBlocking", [](Json& plan) { plan["status"] = "timeout"; }, "lacks the key \"blocking\""},
};

const std::vector<Broken> kMotions{
    {"BrokenChain", [](Json& plan) { at(plan, kDown)["from"]["y"] = std::nextafter(2.0, 3.0); },
     "bit for bit"},
    {"OtherStart", [](Json& plan) { plan["start"]["x"] = 0.61; }, "segment 0: does not start where"},
    {"OtherStartMode", [](Json& plan) { plan["start_mode"] = "lateral"; }, "reached in mode lateral"},
    {"ModeWithoutSwitch", [](Json& plan) { plan["segments"].erase(kChange); },
     "is in mode lateral, reached in"},
    {"EndsBesideTheGoal", [](Json& plan) { plan["goal"]["x"] = 5.311; }, "m from the goal"},
    {"EndsTurnedAway", [](Json& plan) { plan["goal"]["yaw"] = kQuarter + 0.021; }, "rad from the goal's yaw"},
    {"EndsInAnotherMode", [](Json& plan) { plan["goal_mode"] = "frontal"; }, "not in the goal's mode"},
    {"SenseTheModeLacks", [](Json& plan) { at(plan, kSide)["sense"] = "forward"; }, "cannot move forward"},
    {"AgainstItsSense", [](Json& plan) { at(plan, kWalk)["sense"] = "backward"; }, "m along its sense"},
    {"AcrossItsSense", [](Json& plan) { at(plan, kWalk)["to"]["y"] = 2.000001; }, "m across it"},
    {"YawChangesWalking", [](Json& plan) { at(plan, kWalk)["to"]["yaw"] = 1e-12; }, "the yaw changes"},
    {"PositionChangesTurning", [](Json& plan) { at(plan, kTurn)["to"]["x"] = 4.8000001; },
     "the position changes"},
    {"AngleMissesTheYaw", [](Json& plan) { at(plan, kTurn)["angle_rad"] = 1.57; }, "misses the yaw"},
    {"CrawlTurns",
     [](Json& plan) {
       at(plan, kCrawl) = segment("turn", "crawl", pose(3.1, 2.0, 0.0), pose(3.1, 2.0, 0.1), 1.0);
       at(plan, kCrawl)["angle_rad"] = 0.1;
     },
     "mode crawl cannot turn"},
    {"SwitchNotInTheRobotFile", [](Json& plan) { at(plan, kUp)["to_mode"] = "lateral"; },
     "cannot switch from crawl"},
    {"SwitchDisplacedElsewhere", [](Json& plan) { at(plan, kDown)["to"]["x"] = 3.1 + 2e-9; }, "displacement"},
    {"WalksTooFast", [](Json& plan) { at(plan, kWalk)["duration_s"] = 30.0; }, "duration_s is 30"},
    {"SwitchesTooFast", [](Json& plan) { at(plan, kDown)["duration_s"] = 7.9; }, "should be 8"},
    {"TurnsTooFast", [](Json& plan) { at(plan, kTurn)["duration_s"] = 9.0; }, "duration_s is 9"},
    {"WrongTotalTime", [](Json& plan) { plan["total_time_s"] = 1.0; }, "total_time_s is 1"},
    {"WrongLength", [](Json& plan) { plan["length_m"] = 1.0; }, "length_m is 1"},
};

const std::vector<Broken> kClaims{
    {"ClearanceAboveTheTruth", [](Json& plan) { at(plan, kWalk)["clearance_m"] = 0.20501; },
     "clearance_m is 0.20501"},
    {"ClearanceFarBelowTheTruth", [](Json& plan) { at(plan, kWalk)["clearance_m"] = 0.2039; },
     "more than 1 mm below"},
    {"TurnMeasuredAtItsEndsOnly", [](Json& plan) { at(plan, kTurn)["clearance_m"] = 0.405; },
     "clearance_m is 0.405"},
    {"NearestMissing", [](Json& plan) { at(plan, kWalk)["nearest"] = nullptr; }, "nearest is null"},
    {"NearestUnknown", [](Json& plan) { at(plan, kWalk)["nearest"]["id"] = "ghost"; },
     "sees no obstacle \"ghost\""},
    {"NearestIsAnother", [](Json& plan) { at(plan, kWalk)["nearest"]["id"] = "table"; },
     "nearest \"table\" is at"},
    {"NearestPointOff", [](Json& plan) { at(plan, kWalk)["nearest"]["y"] = 1.603; }, "nearest point is"},
    {"NearestUnseen",
     [](Json& plan) {
       at(plan, kCrawl)["nearest"] = nearest("table", 4.0, 2.0);
     },  // it is above the crawl's slab
     "sees no obstacle \"table\""},
    {"HeadroomMissing", [](Json& plan) { at(plan, kCrawl)["headroom_m"] = nullptr; }, "headroom_m is inf"},
    {"HeadroomTooLarge", [](Json& plan) { at(plan, kCrawl)["headroom_m"] = 0.0901; }, "headroom_m is 0.0901"},
    {"HeadroomInvented", [](Json& plan) { at(plan, kWalk)["headroom_m"] = 0.5; }, "headroom_m is 0.5"},
};

const auto kNameOf = [](const auto& tested) { return std::string(tested.param.name); };
INSTANTIATE_TEST_SUITE_P(Form, JudgeOfBrokenPlans, testing::ValuesIn(kForm), kNameOf);
INSTANTIATE_TEST_SUITE_P(Motions, JudgeOfBrokenPlans, testing::ValuesIn(kMotions), kNameOf);
INSTANTIATE_TEST_SUITE_P(Claims, JudgeOfBrokenPlans, testing::ValuesIn(kClaims), kNameOf);

Scene roomWith(const Box& box) {
  Scene scene = room();
  scene.boxes.push_back(box);
  return scene;
}

struct Hindered {
  const char* name;
  Scene scene;
  const char* sentence;
};

void PrintTo(const Hindered& hindered, std::ostream* out) { *out << hindered.name; }

class JudgeOfHinderedPlans : public testing::TestWithParam<Hindered> {};

TEST_P(JudgeOfHinderedPlans, NamesTheSegment) {
  const std::string text = said(judged(goodPlan(), GetParam().scene));
  EXPECT_NE(text.find(GetParam().sentence), std::string::npos) << "said:\n" << text;
}

Scene roomBounded(const Rect& bounds) {
  Scene scene = room();
  scene.bounds = placed(Pose{}, bounds);
  return scene;
}

INSTANTIATE_TEST_SUITE_P(
    Rooms, JudgeOfHinderedPlans,
    testing::Values(
        Hindered{"ANeedleInTheWay", roomWith({"needle", {1.7001, 2.1, 0.5}, {1e-6, 1e-6, 1.0}, {}}),
                 "segment 0 (translate in frontal): touches"},
        Hindered{"ALatheTouchingTheSide", roomWith({"lathe", {1.0, 2.445, 0.5}, {0.1, 0.5, 1.0}, {}}),
                 "segment 0 (translate in frontal): touches"},
        Hindered{"WithinTheMargin", roomWith({"shelf", {1.0, 2.46, 0.5}, {0.1, 0.5, 1.0}, {}}),
                 "segment 0 (translate in frontal): comes as close as"},
        Hindered{"UnderTheRisingBody", roomWith({"lamp", {4.45, 2.0, 0.5}, {0.05, 0.05, 0.1}, {}}),
                 "segment 3 (switch in crawl): touches"},
        Hindered{"AheadOfTheFallingBody", roomWith({"lamp", {3.4, 2.0, 0.5}, {0.05, 0.05, 0.1}, {}}),
                 "segment 1 (switch in frontal): touches"},
        // Clear of the body at both ends of the turn, not between them: its corner reaches 0.234 m.
        Hindered{"InTheTurnsCorner", roomWith({"rod", {4.8, 2.22, 0.6}, {0.01, 0.01, 0.6}, {}}),
                 "segment 4 (turn in frontal): touches"},
        // The crawl drifts by 0.02 m/m over 1.6 m: 0.032 m on each side of 0.195 m.
        Hindered{"WhereTheCrawlMayDrift", roomWith({"skirting", {4.0, 2.225, 0.1}, {0.2, 0.004, 0.2}, {}}),
                 "segment 2 (translate in crawl): touches"},
        Hindered{"SwitchOutOfBounds", roomBounded({0.0, 3.4, 0.0, 4.0}),
                 "segment 1 (switch in frontal): leaves"},
        Hindered{"StartOutOfBounds", roomBounded({0.5, 6.0, 0.0, 4.0}), "start: is outside the bounds"},
        Hindered{"CrawlDriftsOutOfBounds", roomBounded({0.0, 6.0, 1.78, 4.0}),
                 "segment 2 (translate in crawl): leaves"},
        Hindered{"TableTooLow", roomWith({"drawer", {4.0, 2.0, 0.25}, {0.2, 0.2, 0.1}, {}}),
                 "segment 2 (translate in crawl): touches"}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// The start is 0.01 m from a shelf's end, closer than the margin: leaving may be as close as that.
Scene roomWithShelfAtTheStart(double end_x_m) {
  return roomWith({"shelf", {end_x_m - 0.25, 2.455, 0.5}, {0.5, 0.5, 1.0}, {}});
}

TEST(Judge, LetsTheFirstSegmentBeAsCloseAsTheStart) {
  Json plan = goodPlan();
  at(plan, kWalk)["clearance_m"] = 0.01;
  at(plan, kWalk)["nearest"] = nearest("shelf", 0.6, 2.205);
  EXPECT_EQ(said(judged(plan, roomWithShelfAtTheStart(0.7))), "");
}

TEST(Judge, DoesNotLetALaterSegmentBeCloseOnceTheMarginWasReached) {
  Json plan = goodPlan();
  at(plan, kTurn)["clearance_m"] = 0.01;
  Scene scene = roomWithShelfAtTheStart(0.7);
  scene.boxes.push_back({"rod", {4.8 - std::hypot(0.13, 0.195) - 0.015, 2.0, 0.5}, {0.01, 0.01, 1.0}, {}});
  EXPECT_NE(said(judged(plan, scene)).find("segment 4 (turn in frontal): comes as close as"),
            std::string::npos);
}

TEST(Judge, NeverLetsTheBodyTouchWhereItStarts) {
  const Scene scene = roomWith({"shelf", {0.6, 2.445, 0.5}, {0.5, 0.5, 1.0}, {}});
  EXPECT_NE(said(judged(goodPlan(), scene)).find("start: touches an obstacle"), std::string::npos);
}

/// A skirting 0.255 m from the crawl's middle: 0.06 m off the body, 0.028 m off the widened sweep.
Scene roomWithSkirting() { return roomWith({"skirting", {4.0, 2.305, 0.1}, {0.2, 0.1, 0.2}, {}}); }

TEST(Judge, TakesTheClearanceOfADriftingModeInEitherReadingAndSaysWhich) {
  Json plan = goodPlan();
  at(plan, kCrawl)["nearest"] = nearest("skirting", 4.0, 2.255);
  at(plan, kUp)["nearest"] = nearest("table", 4.2, 2.0);
  for (const auto& [claim_m, reading] : {std::pair{0.06, "without"}, std::pair{0.028, "with"}}) {
    at(plan, kCrawl)["clearance_m"] = claim_m;
    const Verdict verdict = judged(plan, roomWithSkirting());
    EXPECT_EQ(said(verdict), "");
    ASSERT_EQ(verdict.notes.size(), 1U);
    EXPECT_NE(verdict.notes[0].find(std::string("is read ") + reading + " the drift"), std::string::npos);
  }
  at(plan, kCrawl)["clearance_m"] = 0.0265;
  EXPECT_NE(said(judged(plan, roomWithSkirting())).find("more than 1 mm below"), std::string::npos);
}

Json refusal(const std::string& status) {
  Json plan = goodPlan();
  plan["status"] = status;
  plan["message"] = "No.";
  plan["segments"] = Json::array();
  plan["blocking"] = {
      {{"obstacle", "table"}, {"mode", "crawl"}, {"of", "height"}, {"needs_m", 0.2}, {"has_m", 0.1}}};
  return plan;
}

TEST(Judge, TakesAnHonestNo) { EXPECT_EQ(said(judged(refusal("timeout"))), ""); }

TEST(Judge, FindsLiesAboutStartAndGoal) {
  for (const char* status :
       {"start_in_collision", "goal_in_collision", "start_out_of_bounds", "goal_out_of_bounds"})
    EXPECT_NE(said(judged(refusal(status))).find(std::string("says ") + status), std::string::npos) << status;
}

TEST(Judge, RefusesWhatIsNotJson) { EXPECT_FALSE(judgePlan("{\"status\": ", room(), robot()).isSound()); }

}  // namespace
}  // namespace judge
