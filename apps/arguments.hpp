#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/map.hpp"
#include "planner/plan.hpp"
#include "planner/replan.hpp"
#include "server/domain.hpp"

namespace underway {

/// A finite number and nothing else. Errors of all three: kInvalidRequest, a sentence without the flag's
/// name.
[[nodiscard]] Expected<double> parseNumber(std::string_view text);
/// "x,y,yaw" [m, m, rad].
[[nodiscard]] Expected<Pose> parsePose(std::string_view text);
/// "x,y" or "x,y,yaw" [m, m, rad]; the mode is left open.
[[nodiscard]] Expected<Goal> parseGoal(std::string_view text);
/// "ID=x,y,z,lx,ly,lz" or with ",roll,pitch,yaw": an oriented box in the map frame, by its middle and full
/// size [m, rad].
[[nodiscard]] Expected<Obstacle> parseObstacle(std::string_view text);

/// --map and how to read it.
struct MapArguments {
  std::string file;
  MapOptions options;
};

/// What is asked for, by names: which modes there are is known once the robot has been read.
struct QueryArguments {
  std::optional<Pose> start;
  std::string start_mode;   ///< empty: the robot's first
  std::vector<Goal> goals;  ///< any of which will do
  std::string goal_mode;    ///< of all goals; empty: the robot's first
  Policy policy = Policy::kPriority;
  double max_detour = Request{}.max_detour;
  std::chrono::milliseconds deadline{10'000};
};

/// The plan that is being followed, and how far.
struct FollowArguments {
  std::string replan;       ///< its file, if a better one is asked for
  std::string stale;        ///< its file, if only whether it may still be followed is asked
  std::size_t segment = 1;  ///< the robot is in, as tables count them
  double done = 0.0;        ///< share of it
  double gain = Reluctance{}.share;

  [[nodiscard]] bool isGiven() const { return !replan.empty() || !stale.empty(); }
  [[nodiscard]] const std::string& file() const { return replan.empty() ? stale : replan; }
};

/// Where the answer goes, besides the table on standard output.
struct OutputArguments {
  std::string json;  ///< a file, "-" for standard output, or empty
  std::string svg;   ///< a file or empty
};

/// Add the flags to a subcommand. The arguments are filled when the command line is parsed, and must live
/// until then.
CLI::Option* addMap(CLI::App& command, MapArguments& arguments);
void addRobot(CLI::App& command, std::string& robot);
void addQuery(CLI::App& command, QueryArguments& arguments);
/// --replan, which takes what addQuery adds from the plan, and how far the robot is on it. After addQuery.
void addReplan(CLI::App& command, FollowArguments& arguments);
/// --segment and --done.
void addProgress(CLI::App& command, FollowArguments& arguments);
/// An option that may be given several times, each with one value that `parse` turns into a value.
CLI::Option* addObstacles(CLI::App& command, const std::string& flag, std::vector<Obstacle>& obstacles,
                          const std::string& help);
void addOutput(CLI::App& command, OutputArguments& arguments);
/// A file to be written in the end. That its folder is there is checked before any work is done. `shape`:
/// FILE and the like; with "FILE|-" it may be standard output.
CLI::Option* addOutputFile(CLI::App& command, const std::string& flag, std::string& file,
                           const std::string& shape, const std::string& help);
/// --pose and the like.
CLI::Option* addPose(CLI::App& command, const std::string& flag, std::optional<Pose>& pose,
                     const std::string& help);
/// --domain and --network: where robots and servers meet.
void addDomain(CLI::App& command, DomainSettings& domain);
/// A finite number from `least` to `most`, and nothing else; "inf" only where `most` is infinite. (CLI11's
/// own ranges let NaN pass.)
CLI::Option* addNumber(CLI::App& command, const std::string& flag, double& number, double least, double most,
                       const std::string& shape, const std::string& help);
/// A whole number from 0 to the largest of 64 bits, and nothing else.
CLI::Option* addWhole(CLI::App& command, const std::string& flag, std::uint64_t& number,
                      const std::string& help);
/// One from `least` to `most`, given to `keep`.
CLI::Option* addWholeInto(CLI::App& command, const std::string& flag,
                          const std::function<void(std::uint64_t)>& keep, std::uint64_t least,
                          std::uint64_t most, const std::string& help);
/// The same into a variable, which can hold `most`.
template <class Whole>
CLI::Option* addWhole(CLI::App& command, const std::string& flag, Whole& number, std::uint64_t least,
                      std::uint64_t most, const std::string& help) {
  const auto keep = [&number](std::uint64_t whole) { number = static_cast<Whole>(whole); };
  return addWholeInto(command, flag, keep, least, most, help);
}
/// --seed.
void addSeed(CLI::App& command, std::uint64_t& seed);
/// --roadmap: the file in which a roadmap outlives the program (roadmap_store.hpp).
void addRoadmap(CLI::App& command, std::string& file);

/// The request in the robot's modes. Errors: kInvalidRequest when start or goal is missing or a mode is
/// unknown.
[[nodiscard]] Expected<Request> requestOf(const QueryArguments& arguments, const Robot& robot);

}  // namespace underway
