#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/apps/program.hpp"

/// `underway serve` as a user runs it: its roadmap on disk, and its world that changes.
namespace underway {
namespace {

using Json = nlohmann::json;

const std::string kMap = UNDERWAY_SOURCE_DIR "/maps/scenario3.yaml";

std::vector<std::string> serveWords(const std::vector<std::string>& more, const std::string& map = kMap) {
  std::vector<std::string> words{"serve", "--map", map, "--domain", testDomain()};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Outcome client(const std::string& command, const std::vector<std::string>& more) {
  std::vector<std::string> words{command, "--domain", testDomain(), "--json", "-"};
  words.insert(words.end(), more.begin(), more.end());
  return runProgram(words);
}

Outcome ask(const std::vector<std::string>& more) { return client("ask", more); }
Outcome askThrough() { return ask({"--start", "0.6,2,0", "--goal", "5.4,2,0"}); }

/// Runs a server from its start to its end, with one question, and returns what it said on standard error.
std::string runServer(const std::vector<std::string>& words, Json* segments = nullptr) {
  Server server(words);
  EXPECT_EQ(server.firstLine(), "ready") << server.errors();
  const Outcome asked = askThrough();
  EXPECT_EQ(asked.exit_code, 0) << asked.errors;
  if (segments != nullptr) *segments = Json::parse(asked.output)["segments"];
  EXPECT_EQ(server.stop(SIGTERM), 0);
  return server.errors();
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The map with one obstacle more.
std::string mapWith(const Folder& folder, const std::string& obstacle) {
  std::string text = readAll(kMap);
  const std::string list = "obstacles:\n";
  text.insert(text.find(list) + list.size(), "  - " + obstacle + "\n");
  return folder.write("changed.yaml", text);
}

TEST(Serve, KeepsItsRoadmapFromOneRunToTheNext) {
  const Folder folder;
  const std::string file = folder.path("a.roadmap");
  Json plain, first, second;
  runServer(serveWords({}), &plain);
  const std::string grown = runServer(serveWords({"--roadmap", file}), &first);
  EXPECT_TRUE(says(grown, file + ": saved, ")) << grown;
  const std::string bytes = readAll(file);
  const std::string loaded = runServer(serveWords({"--roadmap", file}), &second);
  EXPECT_TRUE(says(loaded, file + ": loaded, ")) << loaded;
  EXPECT_FALSE(says(loaded, "saved")) << loaded;
  EXPECT_EQ(readAll(file), bytes);
  EXPECT_EQ(first, plain);
  EXPECT_EQ(second, plain);
}

TEST(Serve, KeepsTheReadyFileForAsLongAsItAnswers) {
  const Folder folder;
  const std::string file = folder.write("ready", "ready\n");  // a server that was killed has left it
  {
    Server server(serveWords({"--ready-file", file, "--prepare-ms", "0"}));
    ASSERT_EQ(server.firstLine(), "ready");
    EXPECT_EQ(readAll(file), "ready\n");
    EXPECT_EQ(server.stop(SIGTERM), 0);
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  // One that never gets as far leaves no old one either.
  folder.write("ready", "ready\n");
  const Outcome failed = runProgram({"serve", "--map", folder.path("missing.yaml"), "--ready-file", file});
  EXPECT_NE(failed.exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Serve, TwoServersInADomainAreToldByTheSecondAndByThoseWhoAsk) {
  const Server first(serveWords({}));
  ASSERT_EQ(first.firstLine(), "ready") << first.errors();
  EXPECT_FALSE(says(first.errors(), "another server")) << first.errors();
  EXPECT_FALSE(says(askThrough().errors, "servers answer"));
  const Server second(serveWords({}));
  ASSERT_EQ(second.firstLine(), "ready") << second.errors();
  EXPECT_TRUE(says(second.errors(), "another server answers in DDS domain " + testDomain()))
      << second.errors();
  // One that asks may be answered before it has discovered both.
  const auto isTold = [](const auto& question) {
    for (int tries = 0; tries < 20; ++tries) {
      const Outcome asked = question();
      EXPECT_EQ(asked.exit_code, 0) << asked.errors;
      if (says(asked.errors, "2 servers answer in DDS domain " + testDomain())) return true;
    }
    return false;
  };
  EXPECT_TRUE(isTold(askThrough));
  EXPECT_TRUE(isTold([] { return client("change", {}); }));
}

TEST(Serve, DoesNotTakeASocketForAStandardOutputThatIsClosed) {
  const Outcome run = runProgramWithoutOutput(serveWords({"--prepare-ms", "0"}));
  EXPECT_EQ(run.exit_code, 1) << run.errors;
  EXPECT_TRUE(says(run.errors, "cannot write to standard output: Bad file descriptor")) << run.errors;
}

TEST(Serve, SavesWhatRequestsHaveMadeItGrow) {
  const Folder folder;
  const std::string file = folder.path("a.roadmap");
  const std::string map = UNDERWAY_SOURCE_DIR "/maps/flat.yaml";
  Server server(serveWords({"--roadmap", file, "--prepare-ms", "0"}, map));
  ASSERT_EQ(server.firstLine(), "ready");
  EXPECT_TRUE(says(server.errors(), ": saved, 1 batches")) << server.errors();
  // Out of the box room, which one batch does not know how to.
  const Outcome asked = ask({"--start", "9.1,7,1.5708", "--goal", "7,5.2,3.1416"});
  ASSERT_EQ(asked.exit_code, 0) << asked.errors;
  const int batches = Json::parse(asked.output)["stats"]["batches"];
  EXPECT_GT(batches, 1);
  EXPECT_EQ(server.stop(SIGINT), 0);
  EXPECT_TRUE(says(server.errors(), ": saved, " + std::to_string(batches) + " batches")) << server.errors();
  Server again(serveWords({"--roadmap", file, "--prepare-ms", "0"}, map));
  EXPECT_TRUE(says(again.errors(), ": loaded, " + std::to_string(batches) + " batches")) << again.errors();
}

TEST(Serve, GrowsAnewWhereTheFileIsAnotherRobotsOrDamaged) {
  const Folder folder;
  const std::string file = folder.path("a.roadmap");
  runServer(serveWords({"--roadmap", file}));
  const std::string other = runServer(serveWords({"--roadmap", file, "--seed", "5"}));
  EXPECT_TRUE(says(other, "refused, growing anew; the roadmap was grown with seed 1, not 5")) << other;
  EXPECT_TRUE(says(other, ": saved, ")) << other;
  std::string bytes = readAll(file);
  bytes[bytes.size() / 2] ^= 0x10;
  folder.write("a.roadmap", bytes);
  const std::string damaged = runServer(serveWords({"--roadmap", file, "--seed", "5"}));
  EXPECT_TRUE(says(damaged, "refused, growing anew; ")) << damaged;
  EXPECT_TRUE(says(runServer(serveWords({"--roadmap", file, "--seed", "5"})), ": loaded, "));
}

TEST(Serve, NeitherWritesOverAForeignFileNorFailsWhereItCannotWrite) {
  const Folder folder;
  const std::string file = folder.write("mine.yaml", "name: mine\n");
  EXPECT_TRUE(says(runServer(serveWords({"--roadmap", file})), "not written over"));
  EXPECT_EQ(readAll(file), "name: mine\n");
  EXPECT_TRUE(says(runServer(serveWords({"--roadmap", "/no/such/folder/a.roadmap"})), "cannot write"));
}

TEST(Serve, LooksAgainAtTheRoadmapOfAnotherMap) {
  const Folder folder;
  const std::string file = folder.path("a.roadmap");
  runServer(serveWords({"--roadmap", file}));
  const std::string map = mapWith(folder, "{id: crate, center_m: [1.2, 2.0, 0.2], size_m: [0.3, 0.3, 0.4]}");
  const std::string said = runServer(serveWords({"--roadmap", file}, map));
  EXPECT_TRUE(says(said, "it was made for another map, so its ways were looked at again")) << said;
}

/// Where a plan's longest translation is half done.
std::pair<double, double> middleOfLongest(const Json& segments) {
  std::pair<double, double> middle;
  double longest = 0.0;
  for (const Json& segment : segments) {
    if (segment["kind"] != "translate" || segment["duration_s"] <= longest) continue;
    longest = segment["duration_s"];
    middle = {0.5 * (segment["from"]["x"].get<double>() + segment["to"]["x"].get<double>()),
              0.5 * (segment["from"]["y"].get<double>() + segment["to"]["y"].get<double>())};
  }
  return middle;
}

class ServeChanging : public testing::Test {
 protected:
  ServeChanging() {
    const Outcome asked = askThrough();
    EXPECT_EQ(asked.exit_code, 0) << asked.errors;
    plan_ = folder_.write("plan.json", asked.output);
    const auto [x, y] = middleOfLongest(Json::parse(asked.output)["segments"]);
    at_ = std::to_string(x) + "," + std::to_string(y) + ",0.1,0.1,0.1,0.2";
  }

  Server server_{serveWords({})};
  Folder folder_;
  std::string plan_;  // a file
  std::string at_;    // a box on its way
};

TEST_F(ServeChanging, AddsMovesAndRemovesObstacles) {
  const Json before = Json::parse(client("change", {}).output);
  EXPECT_EQ(before["revision"], 1);
  const Outcome added = client("change", {"--add", "box=" + at_});
  ASSERT_EQ(added.exit_code, 0) << added.errors;
  const Json after = Json::parse(added.output);
  EXPECT_EQ(after["status"], "ok");
  EXPECT_EQ(after["revision"], 2);
  EXPECT_EQ(after["obstacles"], before["obstacles"].get<int>() + 1);
  EXPECT_GT(after["ways_closed"], 0);
  EXPECT_EQ(Json::parse(askThrough().output)["revision"], 2);
  const Outcome both = client("change", {"--move", "box=3,3.5,0.1,0.1,0.1,0.2", "--remove", "wall_left"});
  EXPECT_EQ(Json::parse(both.output)["revision"], 4);
  EXPECT_NE(runProgram({"change", "--domain", testDomain()}).output.find("revision 4, "), std::string::npos);
}

TEST_F(ServeChanging, APictureIsNotDrawnIntoAnotherMap) {
  const std::string picture = folder_.path("plan.svg");
  const auto drawn = [&](const std::string& map) {
    return ask({"--start", "0.6,2,0", "--goal", "5.4,2,0", "--svg", picture, "--map", map});
  };
  EXPECT_EQ(drawn(kMap).errors, "");
  EXPECT_TRUE(std::filesystem::remove(picture));
  const Outcome other = drawn(UNDERWAY_SOURCE_DIR "/maps/flat.yaml");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(says(other.errors, "the server's map is \"scenario3\", not \"flat\"")) << other.errors;
  EXPECT_EQ(Json::parse(other.output)["status"], "ok");
  EXPECT_FALSE(std::filesystem::exists(picture));
  ASSERT_EQ(client("change", {"--add", "box=" + at_}).exit_code, 0);
  const Outcome changed = drawn(kMap);
  EXPECT_EQ(changed.exit_code, 0) << changed.errors;
  EXPECT_TRUE(says(changed.errors, "another version of the world than the picture shows")) << changed.errors;
  EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST_F(ServeChanging, RemovesAllThatOneRobotSaw) {
  ASSERT_EQ(client("change", {"--add", "nao.seen_1=" + at_, "--add", "nao_2.seen_1=" + at_}).exit_code, 0);
  const Outcome removed = client("change", {"--remove-all", "nao."});
  ASSERT_EQ(removed.exit_code, 0) << removed.errors;
  EXPECT_EQ(Json::parse(removed.output)["revision"], 4);
  EXPECT_EQ(Json::parse(client("change", {"--remove-all", "nao."}).output)["revision"], 4);
}

TEST_F(ServeChanging, RefusesChangesInASentenceAndMakesNone) {
  const Outcome unknown = client("change", {"--remove", "wall_left", "--move", "chair=" + at_});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(says(unknown.errors, "change 2 cannot be made")) << unknown.errors;
  EXPECT_EQ(Json::parse(unknown.output)["revision"], 1);
  const Outcome late = client("change", {"--add", "box=" + at_, "--if-revision", "7"});
  EXPECT_EQ(late.exit_code, 3);
  EXPECT_EQ(Json::parse(late.output)["status"], "stale_revision");
  EXPECT_EQ(client("change", {"--add", "box=1,2,3"}).exit_code, 2);
}

TEST_F(ServeChanging, TellsWhetherAPlanMayStillBeFollowedAndReplans) {
  EXPECT_EQ(ask({"--stale", plan_}).exit_code, 0);
  const Json kept = Json::parse(ask({"--replan", plan_, "--segment", "1", "--done", "0.5"}).output);
  EXPECT_EQ(kept["is_new"], false) << kept["message"];
  ASSERT_EQ(client("change", {"--add", "box=" + at_}).exit_code, 0);
  const Outcome stale = ask({"--stale", plan_});
  EXPECT_EQ(stale.exit_code, 3);
  EXPECT_EQ(Json::parse(stale.output)["status"], "stale_revision");
  EXPECT_TRUE(says(stale.errors, "blocked now by box")) << stale.errors;
  const Outcome told = runProgram({"ask", "--domain", testDomain(), "--stale", plan_});
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_EQ(told.output.rfind("Stale: segment ", 0), 0U) << told.output;
  EXPECT_EQ(told.errors, "");
  const Outcome fresh = ask({"--replan", plan_});
  ASSERT_EQ(fresh.exit_code, 0) << fresh.errors;
  EXPECT_EQ(Json::parse(fresh.output)["is_new"], true);
  EXPECT_EQ(Json::parse(fresh.output)["revision"], 2);
  const Outcome beyond = ask({"--replan", plan_, "--segment", "999"});
  EXPECT_EQ(beyond.exit_code, 2);
  EXPECT_TRUE(says(beyond.errors, "--segment")) << beyond.errors;
}

TEST_F(ServeChanging, LeadsToTheBestOfSeveralGoals) {
  const Outcome asked = ask({"--start", "0.6,2,0", "--goal", "5.4,2", "--goal", "9,9", "--goal", "1.2,2"});
  EXPECT_EQ(asked.exit_code, 0) << asked.errors;
  EXPECT_EQ(Json::parse(asked.output)["goal_index"], 2);
}

TEST_F(ServeChanging, AMapOnDiskIsAskedTheSameWithoutAServer) {
  const std::string map = mapWith(folder_, "{id: box, center_m: [" + at_.substr(0, at_.find(",0.1")) +
                                               ", 0.1], size_m: [0.1, 0.1, 0.2]}");
  EXPECT_EQ(runProgram({"check", plan_, "--map", kMap, "--stale"}).exit_code, 0);
  const Outcome stale = runProgram({"check", plan_, "--map", map, "--stale"});
  EXPECT_EQ(stale.exit_code, 3) << stale.errors;
  EXPECT_TRUE(says(stale.output, "Stale: segment ")) << stale.output;
  EXPECT_TRUE(says(stale.output, "blocked now by box")) << stale.output;
  const Outcome kept = runProgram({"plan", "--map", kMap, "--replan", plan_, "--json", "-"});
  EXPECT_EQ(Json::parse(kept.output)["is_new"], false) << kept.errors;
  const Outcome fresh =
      runProgram({"plan", "--map", map, "--replan", plan_, "--json", folder_.path("new.json")});
  EXPECT_EQ(fresh.exit_code, 0) << fresh.errors;
  EXPECT_TRUE(says(fresh.output, "A new plan: segment ")) << fresh.output;
  EXPECT_EQ(runProgram({"check", folder_.path("new.json"), "--map", map}).exit_code, 0);
}

}  // namespace
}  // namespace underway
