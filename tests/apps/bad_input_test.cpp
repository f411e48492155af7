#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>

#include "tests/apps/program.hpp"

/// What a user can get wrong: each is one clear sentence and the right exit code, never a crash.
namespace underway {
namespace {

constexpr const char* kScenario =
    "name: room\n"
    "floor_z_m: 0.0\n"
    "bounds_m: {min: [0.0, 0.0], max: [6.0, 4.0]}\n"
    "obstacles:\n"
    "  - {id: pillar, center_m: [3.0, 2.0, 0.5], size_m: [0.2, 0.2, 1.0]}\n";

/// The text with one part of it replaced. Throws if the part is not there: no case shall test nothing.
std::string with(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);  // throws for npos
}

/// A map_server YAML for "image.pgm" with these thresholds.
std::string mapServerYaml(const std::string& occupied, const std::string& free) {
  return "image: image.pgm\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: " +
         occupied + "\nfree_thresh: " + free + "\n";
}

std::string whiteImage() { return "P5\n20 20\n255\n" + std::string(400, '\xFE'); }

std::vector<std::string> planWords(const std::string& map, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"plan",  "--map",         map,   "--start", "0.6,2,0", "--goal",
                                 "5.4,2", "--deadline-ms", "2000"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// One line on standard error that begins with "underway: " and contains what matters.
void expectOneSentence(const Outcome& run, int exit_code, const std::string& about) {
  EXPECT_EQ(run.exit_code, exit_code) << run.errors;
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  EXPECT_EQ(run.errors.rfind("underway: ", 0), 0U) << run.errors;
  EXPECT_NE(run.errors.find(about), std::string::npos) << run.errors << "\ndoes not say: " << about;
}

struct FileCase {
  std::string name;
  std::string text;
  std::string about;  ///< what the sentence must mention
};

void PrintTo(const FileCase& tested, std::ostream* out) { *out << tested.name; }

/// The case's name, for the test's.
struct CaseName {
  template <class Case>
  std::string operator()(const testing::TestParamInfo<Case>& tested) const {
    return tested.param.name;
  }
};

class BadScenario : public testing::TestWithParam<FileCase> {};

TEST_P(BadScenario, IsRefusedInOneSentence) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", GetParam().text);
  expectOneSentence(runProgram(planWords(map)), 2, GetParam().about);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadScenario,
    testing::Values(
        FileCase{"Empty", "", "map.yaml"}, FileCase{"AList", "- 1\n- 2\n", "map.yaml"},
        FileCase{"NoYaml", "{{{{: [", "map.yaml"}, FileCase{"Binary", std::string(300, '\0'), "map.yaml"},
        FileCase{"UnknownKey", std::string(kScenario) + "colour: red\n", "colour"},
        FileCase{"ZeroSize", with(kScenario, "size_m: [0.2, 0.2, 1.0]", "size_m: [0.2, 0.0, 1.0]"),
                 "map.yaml:5: obstacles[0].size_m"},
        FileCase{"NegativeSize", with(kScenario, "size_m: [0.2, 0.2, 1.0]", "size_m: [0.2, -0.2, 1.0]"),
                 "map.yaml:5: obstacles[0].size_m"},
        FileCase{"NanInAnObstacle", with(kScenario, "center_m: [3.0", "center_m: [.nan"), "map.yaml"},
        FileCase{
            "DuplicateId",
            std::string(kScenario) + "  - {id: pillar, center_m: [1, 1, 0.5], size_m: [0.2, 0.2, 1.0]}\n",
            "pillar"},
        FileCase{"BoundsWithoutInside", with(kScenario, "max: [6.0, 4.0]", "max: [0.0, 4.0]"), "bounds"},
        FileCase{"MissingMapImage", std::string(kScenario) + "map: {image: nowhere.yaml, height_m: 2.0}\n",
                 "nowhere.yaml"},
        FileCase{"MissingImage", mapServerYaml("0.65", "0.196"), "image.pgm"},
        FileCase{"DeepNesting", std::string(100'000, '['), "map.yaml"}),
    CaseName());

class BadImage : public testing::TestWithParam<FileCase> {};

TEST_P(BadImage, IsRefusedInOneSentence) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", mapServerYaml("0.65", "0.196"));
  folder.write("image.pgm", GetParam().text);
  expectOneSentence(runProgram(planWords(map)), 2, GetParam().about);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadImage,
    testing::Values(FileCase{"Empty", "", "image.pgm"},
                    FileCase{"Truncated", whiteImage().substr(0, 200), "image.pgm"},
                    FileCase{"WrongMagic", "Q5" + whiteImage().substr(2), "image.pgm"},
                    FileCase{"ZeroWidth", "P5\n0 20\n255\n", "image.pgm"},
                    FileCase{"NegativeWidth", "P5\n-20 20\n255\n", "image.pgm"},
                    FileCase{"HugeClaim", "P5\n20000 20000\n255\n" + std::string(1000, 'x'), "image.pgm"},
                    FileCase{"HugerClaim", "P5\n4294967297 4294967297\n255\nx", "image.pgm"}),
    CaseName());

class BadRobot : public testing::TestWithParam<FileCase> {};

TEST_P(BadRobot, IsRefusedInOneSentence) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", kScenario);
  const std::string robot = folder.write("robot.yaml", GetParam().text);
  expectOneSentence(runProgram(planWords(map, {"--robot", robot})), 2, GetParam().about);
}

constexpr const char* kRobot =
    "name: box\n"
    "margin_m: 0.02\n"
    "modes:\n"
    "  walk: {body_m: {x: [-0.1, 0.1], y: [-0.1, 0.1], z: [0.0, 0.5]}, speed_mps: {forward: 0.1}, "
    "turn_speed_radps: 0.2}\n"
    "  roll: {body_m: {x: [-0.1, 0.1], y: [-0.1, 0.1], z: [0.0, 0.2]}, speed_mps: {forward: 0.1}, "
    "turn_speed_radps: 0.0}\n"
    "switches:\n"
    "  - {from: walk, to: roll, duration_s: 1.0}\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadRobot,
    testing::Values(FileCase{"AList", "- 1\n", "robot.yaml"}, FileCase{"Empty", "", "robot.yaml"},
                    FileCase{"UnknownKey", std::string(kRobot) + "wheels: 4\n", "wheels"},
                    FileCase{"UnknownSense", with(kRobot, "{forward: 0.1}", "{upward: 0.1}"), "upward"},
                    FileCase{"UnknownModeInASwitch", with(kRobot, "to: roll", "to: swim"), "swim"},
                    FileCase{"BodyInsideOut", with(kRobot, "[-0.1, 0.1]", "[0.1, -0.1]"), "body_m"},
                    FileCase{"NanSpeed", with(kRobot, "{forward: 0.1}", "{forward: .nan}"), "robot.yaml"},
                    FileCase{"NegativeMargin", with(kRobot, "0.02", "-0.02"), "margin_m"},
                    FileCase{"NoModes", "name: box\nmargin_m: 0.0\nmodes: {}\n", "modes"}),
    CaseName());

struct FlagCase {
  std::string name;
  std::vector<std::string> words;
  std::string about;
};

void PrintTo(const FlagCase& tested, std::ostream* out) { *out << tested.name; }

class BadFlag : public testing::TestWithParam<FlagCase> {};

TEST_P(BadFlag, IsRefusedInOneSentence) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", kScenario);
  std::vector<std::string> words = GetParam().words;
  std::replace(words.begin(), words.end(), std::string("MAP"), map);
  expectOneSentence(runProgram(words), 2, GetParam().about);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadFlag,
    testing::Values(
        FlagCase{"NoCommand", {}, "a command is missing; give plan, ask, "},
        FlagCase{"UnknownCommand", {"plann", "--map", "MAP"}, "\"plann\" is no command; give plan, ask, "},
        FlagCase{"MisspeltFlag", {"plan", "--mpa", "MAP"}, "\"--mpa\" is not known"},
        FlagCase{"UnknownFlagWithoutCommand", {"--fly"}, "\"--fly\" is not known"},
        FlagCase{"MisspeltGaitCommand", {"gait", "crwl"}, "\"crwl\" is not known"},
        FlagCase{"UnknownFlag", planWords("MAP", {"--fly"}), "--fly"},
        FlagCase{"NoMap", {"plan", "--start", "0,0,0", "--goal", "1,1"}, "--map"},
        FlagCase{"NoStart", {"plan", "--map", "MAP", "--goal", "1,1"}, "--start"},
        FlagCase{"MissingMap", planWords("/nowhere/map.yaml"), "/nowhere/map.yaml"},
        FlagCase{"MapIsAFolder", planWords("/"), "underway"},
        FlagCase{"NanPose", {"plan", "--map", "MAP", "--start", "nan,0,0", "--goal", "1,1"}, "--start"},
        FlagCase{"InfiniteGoal", {"plan", "--map", "MAP", "--start", "0,0,0", "--goal", "inf,1"}, "--goal"},
        FlagCase{"ShortPose", {"plan", "--map", "MAP", "--start", "0,0", "--goal", "1,1"}, "--start"},
        FlagCase{"NanPoseOfQuery", {"query", "--map", "MAP", "--pose", "0,nan,0"}, "--pose"},
        FlagCase{"UnknownStartMode", planWords("MAP", {"--start-mode", "flying"}), "flying"},
        FlagCase{"UnknownGoalMode", planWords("MAP", {"--goal-mode", "flying"}), "flying"},
        FlagCase{"UnknownPolicy", planWords("MAP", {"--policy", "cheapest"}), "--policy"},
        FlagCase{"UnknownQuery", {"plan", "--map", "MAP", "--query", "nothing"}, "nothing"},
        FlagCase{"QueryAndStart", {"plan", "--map", "MAP", "--query", "q", "--start", "0,0,0"}, "--query"},
        FlagCase{"UnknownRobot", planWords("MAP", {"--robot", "r2d2"}), "r2d2"},
        FlagCase{"MissingRobotFile", planWords("MAP", {"--robot", "./r2d2.yaml"}), "r2d2.yaml"},
        FlagCase{"ImageFlagsForAScenario", planWords("MAP", {"--resolution-m", "0.05"}), "resolution"},
        FlagCase{
            "PictureOfAskWithoutMap", {"ask", "--start", "0,0,0", "--goal", "1,1", "--svg", "x"}, "--map"},
        FlagCase{
            "DomainOutOfRange", {"ask", "--start", "0,0,0", "--goal", "1,1", "--domain", "999"}, "--domain"},
        FlagCase{"UnknownBenchmark", {"bench", "flying"}, "flying"},
        FlagCase{"BenchmarkOfAMissingGrid", {"bench", "geometry", "--grid", "/nowhere.pgm"}, "/nowhere.pgm"},
        FlagCase{"OptionOfAnotherBenchmark", {"bench", "scenarios", "--quick"}, "--quick"},
        FlagCase{"MapOfAPartThatHasNone",
                 {"bench", "local", "--only", "pure", "--map", "maps/flat.yaml"},
                 "--map"},
        FlagCase{"CheckOfNothing", {"check", "/nowhere.json", "--map", "MAP"}, "/nowhere.json"},
        FlagCase{"CheckOfAMap", {"check", "MAP", "--map", "MAP"}, "map.yaml\": the plan is not JSON: line 1"},
        FlagCase{"GaitOfAMap", {"gait", "crawl", "--gait", "MAP"}, "map.yaml:1: is not JSON; correct it"},
        FlagCase{"NegativeSeed", planWords("MAP", {"--seed", "-1"}), "--seed: \"-1\""},
        FlagCase{"SeedOf65Bits", planWords("MAP", {"--seed", "18446744073709551616"}), "--seed"},
        FlagCase{"PictureToStandardOutput", planWords("MAP", {"--svg", "-"}), "--svg: cannot write \"-\""},
        FlagCase{"ReadyFileInNoFolder",
                 {"serve", "--map", "MAP", "--ready-file", "/nowhere/ready"},
                 "--ready-file: cannot write \"/nowhere/ready\""},
        FlagCase{"NanNoise", {"run", "--map", "MAP", "--noise", "nan"}, "--noise: \"nan\" is not finite"},
        FlagCase{"NanRate", {"sim", "--map", "MAP", "--start", "1,1,0", "--rate", "nan"}, "--rate"},
        FlagCase{"HexadecimalLimit", {"run", "--map", "MAP", "--limit-s", "0x5"}, "--limit-s: \"0x5\""},
        FlagCase{"NanTimeout",
                 {"follow", "--map", "MAP", "--goal", "1,1", "--robot-timeout-s", "nan"},
                 "--robot-timeout-s"},
        FlagCase{"NanTurn", {"gait", "crawl", "--turn-rad", "nan"}, "--turn-rad"},
        FlagCase{"NanHeight", {"gait", "optimise", "--height-m", "nan"}, "--height-m"},
        FlagCase{"NanOwnTime", {"bench", "planner", "--own-s", "nan"}, "--own-s"},
        FlagCase{"HexadecimalDomain", {"change", "--domain", "0x5"}, "--domain: \"0x5\""},
        FlagCase{"NegativeRevision", {"change", "--if-revision", "-1"}, "--if-revision: \"-1\""},
        FlagCase{"SegmentOfNoPlan", planWords("MAP", {"--segment", "2"}), "--segment requires --replan"},
        FlagCase{"DoneOfNoPlan", {"ask", "--start", "0,0,0", "--goal", "1,1", "--done", "0.5"}, "--done"},
        FlagCase{"FileWithoutAName", planWords("MAP", {"--json", ""}), "--json is empty"}),
    CaseName());

TEST(BadInput, SwappedThresholdsAreRefused) {
  const Folder folder;
  folder.write("image.pgm", whiteImage());
  const std::string map = folder.write("map.yaml", mapServerYaml("0.196", "0.65"));
  expectOneSentence(runProgram(planWords(map)), 2, "thresh");
}

TEST(BadInput, ABareImageNeedsItsNumbers) {
  const Folder folder;
  const std::string image = folder.write("image.pgm", whiteImage());
  expectOneSentence(runProgram(planWords(image)), 2, "--resolution-m");
}

TEST(BadInput, AStartOutsideIsAValidNo) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", kScenario);
  const Outcome run = runProgram({"plan", "--map", map, "--start", "-3,2,0", "--goal", "5,2", "--json", "-"});
  expectOneSentence(run, 3, "start");
  EXPECT_NE(run.output.find("\"status\": \"start_out_of_bounds\""), std::string::npos) << run.output;
}

TEST(BadInput, ABadMapIsToldInTheJsonToo) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", "- a list\n");
  const std::string json = folder.path("plan.json");
  expectOneSentence(runProgram(planWords(map, {"--json", json})), 2, "map.yaml");
  EXPECT_NE(readAll(json).find("\"status\": \"invalid_map\""), std::string::npos);
}

TEST(BadInput, ABadRobotIsToldInTheJsonToo) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", kScenario);
  const std::string robot = folder.write("robot.yaml", "- a list\n");
  const Outcome run = runProgram(planWords(map, {"--robot", robot, "--json", "-"}));
  expectOneSentence(run, 2, "robot.yaml");
  EXPECT_NE(run.output.find("\"status\": \"invalid_robot\""), std::string::npos);
}

TEST(BadInput, AnOutputThatCannotBeWrittenIsSaid) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", kScenario);
  const Outcome run = runProgram({"query", "--map", map, "--pose", "1,1,0", "--json", "/nowhere/query.json"});
  expectOneSentence(run, 2, "/nowhere/query.json");
}

/// No file may grow above this while it lives, as on a disk that is full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t most_bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{most_bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(BadInput, ADiskThatIsFullLeavesTheOldFileAndNoOther) {
  const Folder folder;
  const std::string map = folder.write("map.yaml", kScenario);
  const std::string old = folder.write("plan.svg", "old");
  const FileSizeLimit limit(4096);
  expectOneSentence(runProgram(planWords(map, {"--svg", old})), 1, "plan.svg\": File too large");
  EXPECT_EQ(readAll(old), "old");
  const std::filesystem::directory_iterator files(std::filesystem::path(old).parent_path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

}  // namespace
}  // namespace underway
