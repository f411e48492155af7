#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/apps/program.hpp"

/// `underway gait` as a user runs it.
namespace underway {
namespace {

using Json = nlohmann::json;

std::size_t linesOf(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(GaitCommand, HelpShowsExamples) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"gait", "--help"}, {"gait", "crawl", "--help"}}) {
    const Outcome run = runProgram(words);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.output.find("Examples:\n  underway gait"), std::string::npos) << run.output;
  }
}

TEST(GaitCommand, ListsTheLibrary) {
  const Outcome run = runProgram({"gait", "list"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  for (const char* name : {"nominal", "thesis", "efficient", "narrow"})
    EXPECT_NE(run.output.find(name), std::string::npos) << run.output;
}

TEST(GaitCommand, WritesTheSameMotionAsCsvAndJson) {
  const Folder folder;
  const std::vector<std::string> words{"gait", "crawl", "--gait", "efficient", "--cycles", "2", "--out"};
  const auto write = [&](const std::string& file) {
    std::vector<std::string> all = words;
    all.push_back(folder.path(file));
    return runProgram(all);
  };
  const Outcome csv = write("crawl.csv");
  EXPECT_EQ(csv.exit_code, 0) << csv.errors;
  EXPECT_NE(csv.output.find("mm a cycle"), std::string::npos) << csv.output;
  EXPECT_EQ(write("crawl.json").exit_code, 0);
  const std::string table = readAll(folder.path("crawl.csv"));
  EXPECT_EQ(table.rfind("time_s,LAnklePitch,", 0), 0U) << table.substr(0, 100);
  const Json json = Json::parse(readAll(folder.path("crawl.json")));
  ASSERT_EQ(json["names"].size(), 23U);
  EXPECT_EQ(json["angleLists"].size(), 23U);
  EXPECT_EQ(json["angleLists"][0].size(), linesOf(table) - 1);
  EXPECT_EQ(json["timeLists"][22].size(), linesOf(table) - 1);
}

TEST(GaitCommand, StandardOutputHoldsOnlyTheTableThatWasAskedFor) {
  const Outcome run = runProgram({"gait", "crawl", "--out", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.output.rfind("time_s,", 0), 0U);
  EXPECT_EQ(run.output.find("advance"), std::string::npos);
}

TEST(GaitCommand, DrawsAndAnimates) {
  const Folder folder;
  const Outcome run = runProgram(
      {"gait", "crawl", "--gait", "fast", "--plot", folder.path("f.svg"), "--html", folder.path("f.html")});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const std::string svg = readAll(folder.path("f.svg"));
  for (const char* what : {"<svg ", "theta3, knee", "ElbowRoll", "AnklePitch", "Torques", "</svg>"})
    EXPECT_NE(svg.find(what), std::string::npos) << what;
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  const std::string html = readAll(folder.path("f.html"));
  const std::size_t begin = html.find("const motion = ") + 15;
  const Json motion = Json::parse(html.substr(begin, html.find(";\n", begin) - begin));
  EXPECT_EQ(motion["times"].size(), motion["frames"].size());
  EXPECT_GT(motion["frames"].size(), 50U);
  EXPECT_EQ(html.find("http"), std::string::npos) << "it needs nothing else";
}

TEST(GaitCommand, GoesDownBeforeAndGetsUpAfter) {
  const Outcome crawl = runProgram({"gait", "crawl", "--out", "-"});
  const Outcome whole = runProgram({"gait", "crawl", "--standing", "--out", "-"});
  EXPECT_EQ(whole.exit_code, 0) << whole.errors;
  EXPECT_GT(linesOf(whole.output), 3 * linesOf(crawl.output));
}

TEST(GaitCommand, OptimisesAGaitThatCanBeCrawled) {
  const Folder folder;
  for (const char* method : {"descent", "genetic"}) {
    const Outcome run = runProgram({"gait", "optimise", "--method", method, "--out", folder.path("mine.json"),
                                    "--plot", folder.path("search.svg")});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("torque, paper's weights"), std::string::npos) << run.output;
    EXPECT_NE(readAll(folder.path("search.svg")).find("best so far"), std::string::npos);
    const Outcome crawl = runProgram({"gait", "crawl", "--gait", folder.path("mine.json")});
    EXPECT_EQ(crawl.exit_code, 0) << crawl.errors;
  }
  const Outcome none = runProgram({"gait", "optimise", "--height-m", "0.09"});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_NE(none.errors.find("allow more height"), std::string::npos) << none.errors;
}

TEST(GaitCommand, SaysThatACrawlWouldTipOver) {
  const Outcome straight = runProgram({"gait", "crawl", "--gait", "narrow"});
  EXPECT_NE(straight.output.find("inside its support"), std::string::npos) << straight.output;
  const Outcome turning = runProgram({"gait", "crawl", "--gait", "narrow", "--turn-rad", "0.03"});
  EXPECT_EQ(turning.exit_code, 0) << turning.errors;
  EXPECT_NE(turning.output.find("at rest it would tip over"), std::string::npos) << turning.output;
}

TEST(GaitCommand, RefusesWithASentence) {
  const Folder folder;
  const std::string broken = folder.write("broken.json", "{\"name\": \"x\"}");
  for (const auto& [words, says] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"gait"}, "give list, crawl, optimise or make"},
           {{"gait", "crawl", "--gait", "moonwalk"}, "nominal"},
           {{"gait", "crawl", "--gait", broken}, "broken.json: about is missing"},
           {{"gait", "crawl", "--cycles", "0"}, "--cycles"},
           {{"gait", "crawl", "--cycles", "many"}, "--cycles"},
           {{"gait", "crawl", "--push-s", "0.1"}, "more time"},
           {{"gait", "crawl", "--turn-rad", "0.2"}, "AnklePitch would be at"},
           {{"gait", "crawl", "--out", "crawl.txt"}, ".csv or .json"}}) {
    const Outcome run = runProgram(words);
    EXPECT_EQ(run.exit_code, 2) << says << run.output;
    EXPECT_EQ(run.output, "");
    EXPECT_EQ(linesOf(run.errors), 1U) << run.errors;
    EXPECT_NE(run.errors.find(says), std::string::npos) << run.errors;
  }
}

}  // namespace
}  // namespace underway
