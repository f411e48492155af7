// Every query of every map of ours, asked of the real program and judged without a line of its code.
// UNDERWAY_SEEDS=N asks with seeds 1..N instead of 1 only.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/judge/judge.hpp"

namespace judge {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = UNDERWAY_SOURCE_DIR;
// Far longer than any answer takes, a proof that there is no way included.
constexpr int kDeadline_ms = 20'000;

struct Query {
  fs::path map;
  std::string name;
  std::string expect;
  std::vector<std::string> must_use;
};

void PrintTo(const Query& query, std::ostream* out) {
  *out << query.map.stem().string() << ": " << query.name;
}

std::vector<Query> queriesOfAllMaps() {
  std::vector<Query> queries;
  for (const auto& entry : fs::directory_iterator(kProject / "maps")) {
    if (entry.path().extension() != ".yaml") continue;
    for (const YAML::Node& node : YAML::LoadFile(entry.path())["queries"])
      queries.push_back({entry.path(), node["name"].as<std::string>(), node["expect"].as<std::string>("ok"),
                         node["must_use"].as<std::vector<std::string>>(std::vector<std::string>{})});
  }
  return queries;
}

int seeds() {
  const char* asked = std::getenv("UNDERWAY_SEEDS");
  return asked != nullptr ? std::max(1, std::atoi(asked)) : 1;
}

struct Answer {
  int exit_code = -1;
  std::string plan;
};

/// A file of this test and process only, taken away again.
struct PlanFile {
  fs::path path = fs::temp_directory_path() / ("underway_plan_" + std::to_string(::getpid()) + ".json");
  ~PlanFile() { fs::remove(path); }
};

Answer ask(const Query& query, int seed) {
  const PlanFile file;
  const std::string command = std::string(UNDERWAY_PROGRAM) + " plan --robot nao --map " +
                              query.map.string() + " --query " + query.name + " --seed " +
                              std::to_string(seed) + " --deadline-ms " + std::to_string(kDeadline_ms) +
                              " --json " + file.path.string() + " >/dev/null 2>&1";
  Answer answer;
  const int status = std::system(command.c_str());
  if (WIFEXITED(status)) answer.exit_code = WEXITSTATUS(status);
  std::ifstream in(file.path);
  answer.plan = {std::istreambuf_iterator<char>(in), {}};
  return answer;
}

std::set<std::string> modesUsed(const nlohmann::json& plan) {
  std::set<std::string> modes;
  for (const auto& segment : plan["segments"]) modes.insert(segment["mode"].get<std::string>());
  return modes;
}

class QueriesOfOurMaps : public testing::TestWithParam<Query> {};

TEST_P(QueriesOfOurMaps, AreAnsweredAsExpectedAndJudgedSound) {
  const Query& query = GetParam();
  const Scene scene = readScene(query.map);
  const RobotFile robot = readRobotFile(kProject / "robots/nao.yaml");
  for (int seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Answer answer = ask(query, seed);
    EXPECT_EQ(answer.exit_code, query.expect == "ok" ? 0 : 3);
    const Verdict verdict = judgePlan(answer.plan, scene, robot);
    for (const std::string& violation : verdict.violations) ADD_FAILURE() << violation;
    if (!verdict.isSound()) continue;
    const auto plan = nlohmann::json::parse(answer.plan);
    EXPECT_EQ(plan["status"], query.expect) << plan["message"];
    const std::set<std::string> used = modesUsed(plan);
    for (const std::string& mode : query.must_use) EXPECT_TRUE(used.contains(mode)) << mode << " is not used";
  }
}

std::string nameOf(const testing::TestParamInfo<Query>& tested) {
  return tested.param.map.stem().string() + "_" + tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(Maps, QueriesOfOurMaps, testing::ValuesIn(queriesOfAllMaps()), nameOf);

}  // namespace
}  // namespace judge
