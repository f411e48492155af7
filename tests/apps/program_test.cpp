#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/apps/program.hpp"

/// The program as a user runs it: what goes where, and what it ends with.
namespace underway {
namespace {

using Json = nlohmann::json;

const std::string kMap = UNDERWAY_SOURCE_DIR "/maps/scenario3.yaml";

std::vector<std::string> planWords(const std::string& query, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"plan", "--map", kMap, "--query", query};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

bool says(const Outcome& run, const std::string& part) {
  return run.errors.find(part) != std::string::npos || (ADD_FAILURE() << run.errors, false);
}

TEST(Program, HelpIsNoError) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--help"},
                                                {"plan", "--help"},
                                                {"ask", "--help"},
                                                {"serve", "--help"},
                                                {"change", "--help"},
                                                {"query", "--help"},
                                                {"check", "--help"}}) {
    const Outcome run = runProgram(words);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    EXPECT_NE(run.output.find("Examples:\n  underway "), std::string::npos) << run.output;
  }
}

TEST(Program, APlanIsATableOnStandardOutput) {
  const Outcome run = runProgram(planWords("under_the_table"));
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  EXPECT_NE(run.output.find("switch to crawl"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("Total "), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find('\x1b'), std::string::npos) << "colours are for terminals";
}

TEST(Program, StandardOutputHoldsOnlyTheJsonThatWasAskedFor) {
  const Outcome run = runProgram(planWords("under_the_table", {"--json", "-"}));
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["robot"], "nao");
  EXPECT_EQ(json["map"], "scenario3");
}

TEST(Program, AValidNoEndsWithThreeAndStillWritesTheJson) {
  const Outcome run = runProgram(planWords("outside", {"--json", "-"}));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(Json::parse(run.output)["status"], "goal_out_of_bounds");
  EXPECT_EQ(run.errors.rfind("underway: ", 0), 0U);
}

TEST(Program, ItsOwnPlanIsSound) {
  const Folder folder;
  const std::string plan = folder.path("plan.json");
  const std::string picture = folder.path("plan.svg");
  ASSERT_EQ(runProgram(planWords("under_the_table", {"--json", plan, "--svg", picture})).exit_code, 0);
  EXPECT_EQ(readAll(picture).rfind("<svg", 0), 0U);
  const Outcome run = runProgram({"check", plan, "--map", kMap});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.output.rfind("Sound: ", 0), 0U) << run.output;
}

TEST(Program, ASpoiltPlanIsFlawed) {
  const Folder folder;
  const std::string plan = folder.path("plan.json");
  ASSERT_EQ(runProgram(planWords("under_the_table", {"--json", plan})).exit_code, 0);
  Json json = Json::parse(readAll(plan));
  json["segments"][0]["duration_s"] = 0.5;
  json["world_hash"] = "0000000000000000";
  const Outcome run = runProgram({"check", folder.write("spoilt.json", json.dump()), "--map", kMap});
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  EXPECT_EQ(run.output.rfind("The plan is stale: it was made for another version of the map.\n", 0), 0U)
      << run.output;
  EXPECT_NE(run.output.find("segment 1: "), std::string::npos) << run.output;
}

TEST(Program, AFailureIsNoPlanToCheck) {
  const Folder folder;
  const std::string file = folder.path("failure.json");
  ASSERT_EQ(runProgram(planWords("outside", {"--json", file})).exit_code, 3);
  const Outcome run = runProgram({"check", file, "--map", kMap});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.errors.find("goal_out_of_bounds"), std::string::npos) << run.errors;
}

TEST(Program, OfSeveralGoalsThePlanSaysWhichItLeadsTo) {
  const Outcome run = runProgram({"plan", "--map", kMap, "--start", "0.6,2,0", "--goal", "9,2", "--goal",
                                  "5.4,2", "--goal", "1.2,2,0", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json json = Json::parse(run.output);
  EXPECT_EQ(json["goal_index"], 2);
  EXPECT_EQ(json["goals"].size(), 3U);
  EXPECT_EQ(json["goal"]["x"], 1.2);
  const Outcome none =
      runProgram({"plan", "--map", kMap, "--start", "0.6,2,0", "--goal", "9,2", "--goal", "2,0.9,0"});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_TRUE(says(none, "goal 1 (9.000 m"));
  EXPECT_TRUE(says(none, "goal 2 (2.000 m"));
}

TEST(Program, TheSameSeedGivesTheSamePlan) {
  const auto segmentsOf = [](const Outcome& run) { return Json::parse(run.output)["segments"]; };
  const std::vector<std::string> words = planWords("under_the_table", {"--json", "-", "--seed", "7"});
  EXPECT_EQ(segmentsOf(runProgram(words)), segmentsOf(runProgram(words)));
}

TEST(Program, ARoadmapIsKeptFromOneRunToTheNext) {
  const Folder folder;
  const std::string file = folder.path("scenario3.roadmap");
  const std::vector<std::string> words = planWords("under_the_table", {"--json", "-", "--roadmap", file});
  const Outcome first = runProgram(words);
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_TRUE(says(first, ": saved, "));
  const Outcome second = runProgram(words);
  EXPECT_TRUE(says(second, ": loaded, "));
  EXPECT_EQ(second.errors.find("saved"), std::string::npos) << second.errors;
  EXPECT_EQ(Json::parse(first.output)["segments"], Json::parse(second.output)["segments"]);
}

TEST(Program, ARoadmapThatDoesNotFitIsGrownAnew) {
  const Folder folder;
  const std::string file = folder.path("scenario3.roadmap");
  ASSERT_EQ(runProgram(planWords("under_the_table", {"--roadmap", file})).exit_code, 0);
  const Outcome run = runProgram(planWords("under_the_table", {"--roadmap", file, "--seed", "5"}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(says(run, "refused, growing anew; the roadmap was grown with seed 1, not 5"));
  EXPECT_TRUE(says(run, ": saved, "));

  folder.write("scenario3.roadmap", readAll(file) + "more");
  EXPECT_TRUE(says(runProgram(planWords("under_the_table", {"--roadmap", file})), "checksum is wrong"));
}

TEST(Program, AFileThatIsNoRoadmapIsNotWrittenOver) {
  const Folder folder;
  const std::string file = folder.write("mine.yaml", "name: mine\n");
  const Outcome run = runProgram(planWords("under_the_table", {"--roadmap", file}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(says(run, "not written over"));
  EXPECT_EQ(readAll(file), "name: mine\n");
}

TEST(Program, ARoadmapThatCannotBeWrittenIsNoReasonToFail) {
  const Outcome run = runProgram(planWords("under_the_table", {"--roadmap", "/no/such/folder/a.roadmap"}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(says(run, "cannot write"));
}

TEST(Program, AQueryTellsTheStateOfEveryMode) {
  // Under the table: only the crawl fits.
  const Outcome run = runProgram({"query", "--map", kMap, "--pose", "4,2,0", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const Json modes = Json::parse(run.output)["modes"];
  ASSERT_EQ(modes.size(), 3U);
  EXPECT_EQ(modes[0]["state"], "touching");
  EXPECT_EQ(modes[0]["hit"], Json::array({"table_top"}));
  EXPECT_EQ(modes[2]["state"], "free");
  EXPECT_NEAR(modes[2]["headroom_m"].get<double>(), 0.09, 1e-9);
}

TEST(Program, AQueryTellsTheMarginFromContact) {
  // The body's front is at x + 0.13 and the wall at 5.95: 0.01 m, less than the margin of 0.02 m.
  const Outcome run = runProgram({"query", "--map", kMap, "--pose", "5.81,2,0", "--json", "-"});
  EXPECT_EQ(Json::parse(run.output)["modes"][0]["state"], "inside_margin") << run.output;
  const Outcome outside = runProgram({"query", "--map", kMap, "--pose", "7,2,0"});
  EXPECT_NE(outside.output.find("out_of_bounds"), std::string::npos) << outside.output;
}

TEST(Program, AskGivesWhatPlanGives) {
  const Folder folder;
  const std::string ready = folder.path("ready");
  Server server({"serve", "--map", kMap, "--domain", testDomain(), "--workers", "1", "--ready-file", ready});
  EXPECT_EQ(server.firstLine(), "ready");
  const Outcome asked =
      runProgram({"ask", "--start", "0.6,2,0", "--goal", "5.4,2,0", "--domain", testDomain(), "--svg",
                  folder.path("asked.svg"), "--map", kMap, "--json", "-"});
  ASSERT_EQ(asked.exit_code, 0) << asked.errors;
  const Outcome planned = runProgram(planWords("under_the_table", {"--json", "-"}));
  EXPECT_EQ(Json::parse(asked.output)["segments"], Json::parse(planned.output)["segments"]);
  EXPECT_EQ(Json::parse(asked.output)["world_hash"], Json::parse(planned.output)["world_hash"]);
  EXPECT_EQ(readAll(folder.path("asked.svg")).rfind("<svg", 0), 0U);
  EXPECT_EQ(readAll(ready), "ready\n");

  const Outcome refused =
      runProgram({"ask", "--start", "0.6,2,0", "--goal", "9,2", "--domain", testDomain(), "--json", "-"});
  EXPECT_EQ(refused.exit_code, 3) << refused.errors;
  EXPECT_EQ(Json::parse(refused.output)["status"], "goal_out_of_bounds");
  EXPECT_EQ(server.stop(SIGINT), 0);
}

TEST(Program, AServerEndsInOrderWhenItIsTerminated) {
  Server server({"serve", "--map", kMap, "--domain", testDomain()});
  EXPECT_EQ(server.firstLine(), "ready");
  EXPECT_EQ(server.stop(SIGTERM), 0);
}

TEST(Program, APlanIsJudgedInAWorldWhereItTurnsInsideAnObstacle) {
  // Searching a turn for its closest heading once took forever when the body touched all the way round.
  const Folder folder;
  const std::string plan = folder.path("plan.json");
  ASSERT_EQ(runProgram(planWords("under_the_table", {"--json", plan})).exit_code, 0);
  const Outcome run = runProgram({"check", plan, "--map", UNDERWAY_SOURCE_DIR "/maps/scenario2a.yaml"});
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  EXPECT_NE(run.output.find("Flawed: "), std::string::npos) << run.output;
  EXPECT_EQ(run.output.rfind("The plan is of map scenario3, not of scenario2a.\n", 0), 0U) << run.output;
}

TEST(Program, WithoutAServerAskEndsWithFour) {
  const Outcome run =
      runProgram({"ask", "--start", "0.6,2,0", "--goal", "5.4,2", "--domain", testDomain(), "--json", "-"});
  EXPECT_EQ(run.exit_code, 4) << run.errors;
  EXPECT_EQ(Json::parse(run.output)["status"], "no_server");
  EXPECT_EQ(run.errors.rfind("underway: ", 0), 0U) << run.errors;
}

}  // namespace
}  // namespace underway
