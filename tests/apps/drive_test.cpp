#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/apps/program.hpp"

/// `underway sim`, `follow` and `run` as a user runs them.
namespace underway {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kMap = UNDERWAY_SOURCE_DIR "/maps/scenario3.yaml";

Words words(const std::string& command, const Words& more) {
  Words all{command, "--map", kMap, "--domain", testDomain()};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// One line on standard error, if there is any, that begins with "underway: ".
std::string sentence(const Outcome& run) {
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  EXPECT_EQ(run.errors.rfind("underway: ", 0), 0U) << run.errors;
  return run.errors;
}

TEST(Run, ArrivesAndWritesAPageThatShowsItAgain) {
  const Folder folder;
  const Outcome run =
      runProgram({"run", "--map", kMap, "--query", "under_the_table", "--html", folder.path("a.html")});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_TRUE(says(run.output, "The robot arrived after ")) << run.output;
  EXPECT_TRUE(says(run.output, "touched nothing")) << run.output;
  for (const char* state :
       {"settling", "walking", "aligning", "going down", "crawling", "getting up", "arrived"})
    EXPECT_TRUE(says(run.errors, state)) << run.errors;
  const std::string page = readAll(folder.path("a.html"));
  const std::string begin = "id=\"run\">";
  const std::size_t from = page.find(begin) + begin.size();
  const Json data = Json::parse(page.substr(from, page.find("</script>", from) - from));
  EXPECT_EQ(data["robot"], "nao");
  EXPECT_EQ(data["plans"].size(), 1U);
  EXPECT_GT(data["truth"]["x"].size(), 500U);
}

TEST(Run, TheSameSeedGivesTheSameRunRoundAThingThatIsNotInTheMap) {
  const Words asked{"run",
                    "--map",
                    kMap,
                    "--start",
                    "0.6,2,0",
                    "--goal",
                    "1.6,3.2",
                    "--seed",
                    "5",
                    "--noise",
                    "2",
                    "--unmapped",
                    "box=1.1,2.6,0.3,0.2,0.2,0.6"};
  const Outcome first = runProgram(asked);
  const Outcome second = runProgram(asked);
  EXPECT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_EQ(first.output, second.output);
  EXPECT_EQ(first.errors, second.errors);
}

TEST(Run, EndsWithThreeWhenWhatItSeesLeavesNoWay) {
  const Outcome run = runProgram({"run", "--map", kMap, "--start", "0.6,2,0", "--goal", "2.7,0.8",
                                  "--unmapped", "shelf=2.0,3.15,0.3,0.1,1.6,0.6"});
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  EXPECT_TRUE(says(run.output, "found no way")) << run.output;
  EXPECT_TRUE(says(run.output, "touched nothing")) << run.output;
}

TEST(Run, RefusesWhatCannotBeInASentence) {
  const Words map{"run", "--map", kMap};
  const auto with = [&](const Words& more) {
    Words all = map;
    all.insert(all.end(), more.begin(), more.end());
    return runProgram(all);
  };
  const Outcome inside = with({"--start", "4,2,0", "--goal", "5.4,2"});
  EXPECT_EQ(inside.exit_code, 3);
  EXPECT_TRUE(says(sentence(inside), "touches table_top"));
  EXPECT_EQ(with({"--query", "nowhere"}).exit_code, 2);
  EXPECT_EQ(with({"--noise", "0"}).exit_code, 2);
  EXPECT_EQ(with({"--unmapped", "box=1,2"}).exit_code, 2);
  EXPECT_EQ(with({"--unmapped", "wall_left=1,2,0.3,0.1,0.1,0.1"}).exit_code, 2);
  EXPECT_EQ(with({"--truth", "no_such.yaml"}).exit_code, 2);
  const Outcome nowhere = with({"--html", "/no/such/folder/a.html"});
  EXPECT_EQ(nowhere.exit_code, 2);  // before it drives
  EXPECT_TRUE(says(sentence(nowhere), "no folder \"/no/such/folder\""));
  EXPECT_EQ(nowhere.output, "");
}

TEST(Follow, WithoutARobotSaysSo) {
  const Outcome run = runProgram(words("follow", {"--goal", "5.4,2", "--robot-timeout-s", "0.3"}));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(says(sentence(run), "no robot was heard for"));
}

TEST(Follow, RefusesItsWordsBeforeItLooksForAnyone) {
  EXPECT_EQ(runProgram(words("follow", {"--goal", "5.4"})).exit_code, 2);
  EXPECT_EQ(runProgram(words("follow", {})).exit_code, 2);
  EXPECT_EQ(runProgram(words("follow", {"--goal", "5.4,2", "--goal-mode", "fly"})).exit_code, 2);
  EXPECT_EQ(runProgram(words("follow", {"--goal", "5.4,2", "--name", "a b"})).exit_code, 2);
  EXPECT_EQ(runProgram(words("follow", {"--goal", "5.4,2", "--scan-topic", "scan"})).exit_code,
            2);  // needs --ros
  EXPECT_EQ(runProgram(words("follow", {"--goal", "5.4,2", "--ros", "--scan-topic", "a b"})).exit_code, 2);
}

TEST(Follow, WithoutAServerEndsWithFour) {
  Server robot(words("sim", {"--start", "0.6,2,0", "--rate", "10"}));
  ASSERT_EQ(robot.firstLine(), "ready") << robot.errors();
  const Outcome run = runProgram(words("follow", {"--goal", "2.7,0.8", "--robot-timeout-s", "60"}));
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_TRUE(says(run.errors, "underway: no plan server answers in DDS domain ")) << run.errors;
  EXPECT_EQ(robot.stop(SIGTERM), 0);
  EXPECT_TRUE(says(robot.errors(), "hears no commands: stands still")) << robot.errors();
}

/// Three programs at once: server, robot and follower.
void expectArrival(const Words& wire) {
  Server server(words("serve", {}));
  ASSERT_EQ(server.firstLine(), "ready") << server.errors();
  Words sim{"--start", "0.6,2,0", "--rate", "15"};
  Words follow{"--goal", "1.3,2.6", "--robot-timeout-s", "60"};
  sim.insert(sim.end(), wire.begin(), wire.end());
  follow.insert(follow.end(), wire.begin(), wire.end());
  Server robot(words("sim", sim));
  ASSERT_EQ(robot.firstLine(), "ready") << robot.errors();
  const Outcome run = runProgram(words("follow", follow));
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_TRUE(says(run.output, "The robot arrived after ")) << run.output;
  EXPECT_TRUE(says(run.errors, "walking (frontal), segment 1 of ")) << run.errors;
  EXPECT_EQ(robot.stop(SIGINT), 0) << robot.errors();  // nothing was touched
  EXPECT_EQ(server.stop(SIGTERM), 0);
}

TEST(Follow, ArrivesOverOurTopics) { expectArrival({}); }
TEST(Follow, ArrivesOverRosTopics) { expectArrival({"--ros"}); }

TEST(Sim, RefusesToStandInATable) {
  const Outcome run = runProgram(words("sim", {"--start", "4,2,0"}));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_TRUE(says(sentence(run), "touches table_top"));
  EXPECT_EQ(runProgram(words("sim", {})).exit_code, 2);
}

}  // namespace
}  // namespace underway
