// The arrows of docs/architecture.md, checked on the sources themselves.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kProject = UNDERWAY_SOURCE_DIR;

/// What each folder may include of ours, besides itself.
const std::map<std::string, std::set<std::string>> kMayInclude{
    {"geometry", {}},
    {"gait", {}},
    {"sim", {"geometry", "gait", "local"}},
    {"planner", {"geometry"}},
    {"server", {"geometry", "planner", "local"}},
    {"local", {"geometry", "planner", "gait"}},
    {"bench", {"geometry", "planner", "gait", "local", "sim", "server"}},
    {"apps", {"geometry", "planner", "gait", "local", "sim", "server", "bench"}},
};

/// The only folder whose sources and headers may include a third party's headers.
const std::map<std::string, std::string> kOwner{{"fcl", "geometry"},   {"hwy", "geometry"},
                                                {"nlopt.hpp", "gait"}, {"ompl", "planner"},
                                                {"dds", "server"},     {"mujoco", "sim"}};

/// And the only place besides: it puts OMPL's planners together with FCL, to race them against ours.
const std::string kPeers = "bench/peers/";
const std::set<std::string> kOfPeers{"fcl", "ompl"};

struct Include {
  std::string file;  ///< from the project's root
  std::size_t line = 0;
  std::string target;  ///< as written, without quotes or brackets
  [[nodiscard]] std::string where() const {
    return file + ":" + std::to_string(line) + " includes " + target;
  }
};

std::string firstFolder(const std::string& path) { return path.substr(0, path.find('/')); }

std::vector<Include> includesOf(const fs::path& file) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> includes;
  std::ifstream in(file);
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line)
    if (std::smatch match; std::regex_search(text, match, kInclude))
      includes.push_back({fs::relative(file, kProject).generic_string(), line, match[1]});
  return includes;
}

std::vector<Include> includesUnder(const std::string& folder) {
  std::vector<Include> includes;
  for (const auto& entry : fs::recursive_directory_iterator(kProject / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".hpp" && extension != ".h") continue;
    for (Include& include : includesOf(entry.path())) includes.push_back(std::move(include));
  }
  return includes;
}

TEST(IncludeRules, FoldersIncludeOnlyWhatStandsBelowThem) {
  for (const auto& [folder, below] : kMayInclude) {
    const std::vector<Include> includes = includesUnder(folder);
    EXPECT_FALSE(includes.empty()) << folder << " has no sources to check";
    for (const Include& include : includes) {
      const std::string target = firstFolder(include.target);
      if (target != folder && kMayInclude.contains(target)) {
        EXPECT_TRUE(below.contains(target)) << include.where() << ", which stands above " << folder;
      }
      EXPECT_NE(target, "tests") << include.where();
    }
  }
}

TEST(IncludeRules, ThirdPartyHeadersStayInTheFolderThatOwnsThem) {
  for (const auto& [folder, below] : kMayInclude)
    for (const Include& include : includesUnder(folder))
      if (const auto owner = kOwner.find(firstFolder(include.target)); owner != kOwner.end()) {
        const bool is_peers = include.file.starts_with(kPeers) && kOfPeers.contains(owner->first);
        EXPECT_TRUE(folder == owner->second || is_peers)
            << include.where() << ", which only " << owner->second << " may";
      }
}

TEST(IncludeRules, OnlyTheBenchesKnowThePeers) {
  for (const auto& [folder, below] : kMayInclude)
    for (const Include& include : includesUnder(folder))
      if (include.target.starts_with(kPeers)) {
        EXPECT_EQ(folder, "bench") << include.where();
      }
}

TEST(IncludeRules, OfTheServerOnlyTheRobotsSideKnowsTheLocalLayer) {
  const std::string robots_side = "server/robot/";
  for (const Include& include : includesUnder("server")) {
    const bool is_robots = include.file.starts_with(robots_side);
    EXPECT_TRUE(is_robots || !include.target.starts_with("local/")) << include.where();
    EXPECT_TRUE(is_robots || !include.target.starts_with(robots_side)) << include.where();
  }
}

TEST(IncludeRules, EveryOwnerUsesWhatItOwns) {
  for (const auto& [library, folder] : kOwner) {
    std::size_t used = 0;
    for (const Include& include : includesUnder(folder))
      used += firstFolder(include.target) == library ? 1 : 0;
    EXPECT_GT(used, 0U) << folder << " owns " << library
                        << " and does not include it: is the rule out of date?";
  }
}

TEST(IncludeRules, IncludesAreWrittenFromTheRoot) {
  for (const auto& [folder, below] : kMayInclude)
    for (const Include& include : includesUnder(folder))
      EXPECT_FALSE(include.target.starts_with(".") ||
                   fs::exists((kProject / include.file).parent_path() / include.target))
          << include.where() << ", which is not written from the root";
}

TEST(IncludeRules, TheJudgeIncludesNothingOfOurs) {
  const std::vector<Include> includes = includesUnder("tests/judge");
  EXPECT_FALSE(includes.empty());
  for (const Include& include : includes) {
    EXPECT_FALSE(kMayInclude.contains(firstFolder(include.target))) << include.where();
    EXPECT_TRUE(firstFolder(include.target) != "tests" || include.target.starts_with("tests/judge/"))
        << include.where();
    EXPECT_FALSE(kOwner.contains(firstFolder(include.target))) << include.where();
  }
}

}  // namespace
