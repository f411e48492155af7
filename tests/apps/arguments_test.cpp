#include "apps/arguments.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace underway {
namespace {

Robot makeRobot() {
  Robot robot;
  robot.name = "nao";
  for (const char* mode : {"frontal", "lateral", "crawl"}) robot.modes.emplace_back().name = mode;
  return robot;
}

/// What parsing this command line with the flags of a query says: empty if it is accepted.
std::string parseQuery(std::vector<std::string> words, QueryArguments& arguments) {
  CLI::App command("test");
  addQuery(command, arguments);
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    command.parse(words);
    return {};
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
}

TEST(Arguments, APoseIsThreeNumbers) {
  EXPECT_EQ(parsePose("0.6,2,-1.5").value(), (Pose{0.6, 2.0, -1.5}));
  EXPECT_EQ(parsePose("-1e-3,.5,0").value(), (Pose{-1e-3, 0.5, 0.0}));
  for (const char* text :
       {"", "1", "1,2", "1,2,3,4", "1,2,", ",1,2", "1 2 3", "1,2,3 ", "1, 2,3", "a,b,c", "0x1,2,3"})
    EXPECT_FALSE(parsePose(text)) << text;
}

TEST(Arguments, NumbersOfAPoseAreFinite) {
  for (const char* text : {"nan,0,0", "0,inf,0", "0,0,-inf", "1e999,0,0", "0,0,NaN", "-nan,0,0"}) {
    const auto pose = parsePose(text);
    ASSERT_FALSE(pose) << text;
    EXPECT_EQ(pose.error().code, ErrorCode::kInvalidRequest);
  }
}

TEST(Arguments, AGoalMayLeaveItsYawFree) {
  EXPECT_EQ(parseGoal("5.4,2").value().yaw, std::nullopt);
  EXPECT_EQ(parseGoal("5.4,2,0").value().yaw, 0.0);
  EXPECT_FALSE(parseGoal("5.4"));
  EXPECT_FALSE(parseGoal("5.4,2,0,1"));
}

TEST(Arguments, NumbersAreReadToTheLastBit) {
  EXPECT_EQ(parseNumber("0.1").value(), 0.1);
  EXPECT_EQ(parseNumber("2.2250738585072014e-308").value(), std::numeric_limits<double>::min());
}

TEST(Arguments, NegativeCoordinatesAreNoFlags) {
  QueryArguments arguments;
  EXPECT_EQ(parseQuery({"--start", "-1,-2,-3", "--goal", "-.5,1"}, arguments), "");
  EXPECT_EQ(arguments.start, (Pose{-1.0, -2.0, -3.0}));
}

TEST(Arguments, WhatIsOutOfRangeIsRefusedWithItsFlag) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--start", "nan,0,0"},  {"--start", "1,2"},       {"--goal", "inf,0"},      {"--policy", "cheapest"},
      {"--max-detour", "0.5"}, {"--max-detour", "nan"},  {"--max-detour", "-inf"}, {"--deadline-ms", "0"},
      {"--deadline-ms", "-5"}, {"--deadline-ms", "nan"}, {"--deadline-ms", "1e30"}};
  for (const auto& [flag, value] : cases) {
    QueryArguments arguments;
    const std::string says = parseQuery({flag, value}, arguments);
    EXPECT_EQ(says.rfind(flag + ": ", 0), 0U) << flag << " " << value << " gives: " << says;
  }
}

/// What an option takes from a text: what is said against it, or nothing.
template <class Add>
std::string parseOne(const std::string& text, const Add& add) {
  CLI::App command("test");
  add(command);
  try {
    command.parse(std::vector<std::string>{text, "--x"});  // from the last to the first
    return {};
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
}

TEST(Arguments, ANumberIsFiniteAndInsideItsRange) {
  const auto parse = [](const std::string& text, double& number) {
    return parseOne(
        text, [&](CLI::App& command) { addNumber(command, "--x", number, 0.01, 1000.0, "F", "A number"); });
  };
  double number = 0.0;
  for (const auto& [text, value] : {std::pair{"0.01", 0.01}, {"1e3", 1000.0}, {"2.5", 2.5}}) {
    EXPECT_EQ(parse(text, number), "");
    EXPECT_EQ(number, value);
  }
  for (const char* text : {"nan", "-nan", "NaN", "inf", "-inf", "0x5", "5 ", "5m", "1001", "0.009", "-1", ""})
    EXPECT_NE(parse(text, number), "") << text;
  EXPECT_EQ(number, 2.5);
  EXPECT_EQ(parse("1e9", number), "--x: \"1e9\" is out of range; give 0.01 to 1000");
}

TEST(Arguments, AWholeNumberIsInsideItsRange) {
  const auto parse = [](const std::string& text, int& number) {
    return parseOne(text, [&](CLI::App& command) { addWhole(command, "--x", number, 1, 256, "A number"); });
  };
  int number = 0;
  EXPECT_EQ(parse("256", number), "");
  EXPECT_EQ(number, 256);
  for (const char* text : {"0", "257", "-1", "0x5", "1.0", "1e2", "nan", "4294967297", ""})
    EXPECT_NE(parse(text, number), "") << text;
  EXPECT_EQ(number, 256);
  EXPECT_EQ(parse("0x5", number), "--x: \"0x5\" is not a whole number from 1 to 256");
}

TEST(Arguments, ARangeIsToldInNumbersThatCanBeRead) {
  QueryArguments arguments;
  EXPECT_EQ(parseQuery({"--deadline-ms", "0"}, arguments),
            "--deadline-ms: \"0\" is out of range; give 1 to 86400000");
}

TEST(Arguments, ADetourWithoutLimitIsSaidAsInf) {
  QueryArguments arguments;
  EXPECT_EQ(parseQuery({"--max-detour", "inf"}, arguments), "");
  EXPECT_EQ(arguments.max_detour, std::numeric_limits<double>::infinity());
}

TEST(Arguments, ARequestNamesTheRobotsModes) {
  QueryArguments arguments;
  EXPECT_EQ(parseQuery({"--start", "0,0,0", "--goal", "1,1,2", "--goal-mode", "crawl", "--policy", "safest"},
                       arguments),
            "");
  const auto request = requestOf(arguments, makeRobot());
  ASSERT_TRUE(request);
  EXPECT_EQ(request->start_mode, 0);
  EXPECT_EQ(request->goal_mode, 2);
  EXPECT_EQ(request->goal_yaw, 2.0);
  EXPECT_EQ(request->policy, Policy::kSafest);
}

TEST(Arguments, AModeThatIsNotTheRobotsIsRefusedWithThoseThatAre) {
  QueryArguments arguments;
  EXPECT_EQ(parseQuery({"--start", "0,0,0", "--goal", "1,1", "--start-mode", "flying"}, arguments), "");
  const auto request = requestOf(arguments, makeRobot());
  ASSERT_FALSE(request);
  EXPECT_EQ(request.error().message,
            "--start-mode: robot \"nao\" has no mode \"flying\"; it has frontal, lateral, crawl");
}

TEST(Arguments, SeveralGoalsAreEachOfTheGoalsMode) {
  QueryArguments arguments;
  EXPECT_EQ(parseQuery({"--start", "0,0,0", "--goal", "1,1,2", "--goal", "-2,.5", "--goal-mode", "crawl"},
                       arguments),
            "");
  const auto request = requestOf(arguments, makeRobot());
  ASSERT_TRUE(request) << request.error().message;
  EXPECT_EQ(goalsOf(*request), (std::vector<Goal>{{{1, 1}, 2.0, 2}, {{-2, 0.5}, {}, 2}}));
}

TEST(Arguments, AnObstacleIsAnIdAndABox) {
  EXPECT_EQ(parseObstacle("box=1,2,3,.4,.5,.6").value(), (Obstacle{"box", {{1, 2, 3}, {0.4, 0.5, 0.6}, {}}}));
  EXPECT_EQ(parseObstacle("a b=1,2,3,4,5,6,.1,.2,-.3").value(),
            (Obstacle{"a b", {{1, 2, 3}, {4, 5, 6}, {0.1, 0.2, -0.3}}}));
  for (const char* text : {"box", "=1,2,3,4,5,6", "box=1,2,3", "box=1,2,3,4,5,6,7", "box=1,2,3,4,5,x", ""})
    EXPECT_FALSE(parseObstacle(text)) << text;
}

TEST(Arguments, ARequestNeedsStartAndGoal) {
  QueryArguments arguments;
  EXPECT_FALSE(requestOf(arguments, makeRobot()));
  arguments.start = Pose{};
  EXPECT_FALSE(requestOf(arguments, makeRobot()));
  arguments.goals = {Goal{}};
  EXPECT_TRUE(requestOf(arguments, makeRobot()));
}

}  // namespace
}  // namespace underway
