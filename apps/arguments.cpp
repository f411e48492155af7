#include "apps/arguments.hpp"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

namespace underway {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Expected<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const Expected<double> number = parseNumber(text.substr(begin, end - begin));
    if (!number) return tl::unexpected(number.error());
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

/// An option whose text is turned into a value, or refused with a sentence, by `parse`.
template <class Value, class Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& flag, Value& value, Parse parse,
                       const std::string& shape, const std::string& help) {
  const auto read = [flag, parse, &value](const std::string& text) {
    const auto parsed = parse(text);
    if (!parsed) throw CLI::ValidationError(flag, parsed.error().message);
    value = *parsed;
  };
  return command.add_option_function<std::string>(flag, read, help)->type_name(shape);
}

/// The same of an option that may be given several times, with one value each.
template <class Value, class Parse>
CLI::Option* addParsedList(CLI::App& command, const std::string& flag, std::vector<Value>& values,
                           Parse parse, const std::string& shape, const std::string& help) {
  const auto read = [flag, parse, &values](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      auto parsed = parse(text);
      if (!parsed) throw CLI::ValidationError(flag, parsed.error().message);
      values.push_back(std::move(*parsed));
    }
  };
  return command.add_option_function<std::vector<std::string>>(flag, read, help)
      ->type_name(shape)
      ->allow_extra_args(false);
}

/// A number as one writes it, without an exponent: "0.01", "86400000".
std::string written(double number) {
  std::array<char, 512> text;  // holds any double in full
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  return {text.data(), end};
}

/// A number inside a range; `inf` only where the range ends there. (CLI::Range lets NaN pass.)
auto within(double least, double most) {
  return [=](const std::string& text) -> Expected<double> {
    const Expected<double> number = most == kInfinity && text == "inf" ? kInfinity : parseNumber(text);
    if (!number || (*number >= least && *number <= most)) return number;
    const std::string upper = most == kInfinity ? " or more" : " to " + written(most);
    return fail(ErrorCode::kInvalidRequest,
                "\"" + text + "\" is out of range; give " + written(least) + upper);
  };
}

/// How far along a plan says nothing without that plan.
void refuseProgressOfNothing(const CLI::App& command) {
  for (const char* const plan : {"--replan", "--stale"})
    if (const CLI::Option* const option = command.get_option_no_throw(plan); option && option->count() > 0)
      return;
  for (const char* const flag : {"--segment", "--done", "--gain"})
    if (command.count(flag) > 0) throw CLI::RequiresError(flag, "--replan");
}

/// (CLI11 takes -1 for the largest one, and 0x5 for 5.)
Expected<std::uint64_t> parseWhole(const std::string& text, std::uint64_t least, std::uint64_t most) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc{} && stopped == end && number >= least && number <= most) return number;
  return fail(ErrorCode::kInvalidRequest, "\"" + text + "\" is not a whole number from " +
                                              std::to_string(least) + " to " + std::to_string(most));
}

/// The name of a file, if its folder can take one; "-" only where that is standard output.
Expected<std::string> mayBeWritten(const std::string& name, bool may_be_output) {
  const std::filesystem::path file(name);
  const std::filesystem::path parent = file.parent_path();
  const std::filesystem::path folder = parent.empty() ? "." : parent;
  const auto refuse = [&](const std::string& why) {
    return fail(ErrorCode::kInvalidRequest, "cannot write \"" + name + "\": " + why);
  };
  std::error_code error;
  if (name.empty()) return name;  // main says it of every option
  if (name == "-" && may_be_output) return name;
  if (name == "-") return refuse("this does not go to standard output; give a file");
  if (std::filesystem::is_directory(file, error)) return refuse("it is a folder; give a file in it");
  if (!std::filesystem::is_directory(folder, error))
    return refuse("there is no folder \"" + folder.string() + "\"; make it first");
  if (access(folder.c_str(), W_OK) != 0 && access(file.c_str(), W_OK) != 0)
    return refuse("folder \"" + folder.string() + "\" cannot be written to");
  return name;
}

Expected<ModeId> modeOf(const std::string& mode_name, const std::string& flag, const Robot& robot) {
  if (mode_name.empty()) return ModeId{0};
  if (const std::optional<ModeId> mode = robot.findMode(mode_name)) return *mode;
  std::string known;
  for (const Mode& mode : robot.modes) known += (known.empty() ? "" : ", ") + mode.name;
  return fail(ErrorCode::kInvalidRequest,
              flag + ": robot \"" + robot.name + "\" has no mode \"" + mode_name + "\"; it has " + known);
}

}  // namespace

Expected<double> parseNumber(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stopped != end || text.empty())
    return fail(ErrorCode::kInvalidRequest, "\"" + std::string(text) + "\" is not a number");
  if (!std::isfinite(number))
    return fail(ErrorCode::kInvalidRequest,
                "\"" + std::string(text) + "\" is not finite; give finite numbers");
  return number;
}

Expected<Pose> parsePose(std::string_view text) {
  const Expected<std::vector<double>> numbers = parseNumbers(text);
  if (!numbers) return tl::unexpected(numbers.error());
  if (numbers->size() != 3)
    return fail(ErrorCode::kInvalidRequest, "\"" + std::string(text) + "\" is not a pose; give x,y,yaw");
  return Pose{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

Expected<Goal> parseGoal(std::string_view text) {
  const Expected<std::vector<double>> numbers = parseNumbers(text);
  if (!numbers) return tl::unexpected(numbers.error());
  if (numbers->size() != 2 && numbers->size() != 3)
    return fail(ErrorCode::kInvalidRequest,
                "\"" + std::string(text) + "\" is not a goal; give x,y or x,y,yaw");
  Goal goal{{(*numbers)[0], (*numbers)[1]}};
  if (numbers->size() == 3) goal.yaw = (*numbers)[2];
  return goal;
}

Expected<Obstacle> parseObstacle(std::string_view text) {
  const std::size_t sign = text.find('=');
  if (sign != std::string_view::npos && sign > 0) {
    const Expected<std::vector<double>> n = parseNumbers(text.substr(sign + 1));
    if (!n) return tl::unexpected(n.error());
    const Vec3 rpy = n->size() == 9 ? Vec3{(*n)[6], (*n)[7], (*n)[8]} : Vec3{};
    if (n->size() == 6 || n->size() == 9)
      return Obstacle{std::string(text.substr(0, sign)),
                      {{(*n)[0], (*n)[1], (*n)[2]}, {(*n)[3], (*n)[4], (*n)[5]}, rpy}};
  }
  return fail(ErrorCode::kInvalidRequest,
              "\"" + std::string(text) + "\" is not an obstacle; give ID=x,y,z,lx,ly,lz[,roll,pitch,yaw]");
}

CLI::Option* addMap(CLI::App& command, MapArguments& arguments) {
  CLI::Option* const map =
      command.add_option("--map", arguments.file, "Scenario YAML, ROS map_server YAML, or an image")
          ->type_name("FILE");
  MapOptions& options = arguments.options;
  const auto unknown = [](const std::string& text) -> Expected<Unknown> {
    if (text == "occupied") return Unknown::kOccupied;
    if (text == "free") return Unknown::kFree;
    return fail(ErrorCode::kInvalidRequest, "\"" + text + "\" is neither \"occupied\" nor \"free\"");
  };
  addParsed(command, "--unknown", options.unknown, unknown, "occupied|free",
            "What unseen cells count as (occupied)");
  addParsed(command, "--resolution-m", options.resolution_m, within(1e-6, 1e5), "R",
            "Image only: size of a cell");
  addParsed(command, "--origin", options.origin, parsePose, "X,Y,YAW",
            "Image only: pose of the lower left corner");
  addParsed(command, "--occupied-thresh", options.occupied_thresh, within(0.0, 1.0), "P",
            "Image only: cells above are walls");
  addParsed(command, "--free-thresh", options.free_thresh, within(0.0, 1.0), "P",
            "Image only: cells below are free");
  return map;
}

void addRobot(CLI::App& command, std::string& robot) {
  robot = "nao";
  command.add_option("--robot", robot, "A robot file, or the name of one that comes along (nao)")
      ->type_name("FILE|NAME");
}

CLI::Option* addPose(CLI::App& command, const std::string& flag, std::optional<Pose>& pose,
                     const std::string& help) {
  return addParsed(command, flag, pose, parsePose, "X,Y,YAW", help);
}

void addQuery(CLI::App& command, QueryArguments& arguments) {
  const auto policy = [](const std::string& text) -> Expected<Policy> {
    if (const std::optional<Policy> found = findPolicy(text)) return *found;
    return fail(ErrorCode::kInvalidRequest, "\"" + text + "\" is none of priority, fastest, safest");
  };
  const auto deadline = [](const std::string& text) -> Expected<std::chrono::milliseconds> {
    constexpr double kDay_ms = 86'400'000.0;
    return within(1.0, kDay_ms)(text).map(
        [](double ms) { return std::chrono::milliseconds(static_cast<std::int64_t>(ms)); });
  };
  addPose(command, "--start", arguments.start, "Where the robot is [m, m, rad]");
  command.add_option("--start-mode", arguments.start_mode, "Mode it is in (the robot's first)")
      ->type_name("MODE");
  addParsedList(command, "--goal", arguments.goals, parseGoal, "X,Y[,YAW]",
                "Where it shall be; without a yaw, any. Of several the best to reach by the policy");
  command.add_option("--goal-mode", arguments.goal_mode, "Mode it shall be in (the robot's first)")
      ->type_name("MODE");
  addParsed(command, "--policy", arguments.policy, policy, "priority|fastest|safest",
            "What 'best' means (priority)");
  addNumber(command, "--max-detour", arguments.max_detour, 1.0, kInfinity, "F",
            "priority takes the fastest plan when its own takes F times as long (3; inf: never)");
  addParsed(command, "--deadline-ms", arguments.deadline, deadline, "N", "Time for the answer (10000)");
}

void addReplan(CLI::App& command, FollowArguments& arguments) {
  command
      .add_option("--replan", arguments.replan,
                  "The plan being followed: leave it if it is blocked, or for a better one. Start (where the "
                  "robot is by --segment and --done), goals and policy are the plan's")
      ->type_name("PLAN.json")
      ->excludes("--start-mode", "--goal-mode", "--policy", "--max-detour");
  addProgress(command, arguments);
  addNumber(command, "--gain", arguments.gain, 0.0, 1.0, "F",
            "What a new plan must save of the time that is left, besides 2 s (0.1)");
  command.parse_complete_callback([&command] { refuseProgressOfNothing(command); });
}

void addProgress(CLI::App& command, FollowArguments& arguments) {
  addWhole(command, "--segment", arguments.segment, 1, 100'000,
           "Segment the robot is in, counted from 1 (1)");
  addNumber(command, "--done", arguments.done, 0.0, 1.0, "F", "Share of that segment that is done (0)");
}

CLI::Option* addObstacles(CLI::App& command, const std::string& flag, std::vector<Obstacle>& obstacles,
                          const std::string& help) {
  return addParsedList(command, flag, obstacles, parseObstacle, "ID=X,Y,Z,LX,LY,LZ[,R,P,Y]", help);
}

void addOutput(CLI::App& command, OutputArguments& arguments) {
  addOutputFile(command, "--json", arguments.json, "FILE|-",
                "Write the plan, or why there is none; - for standard output");
  addOutputFile(command, "--svg", arguments.svg, "FILE", "Draw map and plan");
}

CLI::Option* addOutputFile(CLI::App& command, const std::string& flag, std::string& file,
                           const std::string& shape, const std::string& help) {
  const auto parse = [may_be_output = shape.ends_with("|-")](const std::string& name) {
    return mayBeWritten(name, may_be_output);
  };
  return addParsed(command, flag, file, parse, shape, help);
}

void addDomain(CLI::App& command, DomainSettings& domain) {
  addWhole(command, "--domain", domain.id, 0, Domain::kLargestId, "DDS domain, 0 to 230 (0)");
  command.add_flag("--network", domain.use_network, "Meet other machines too, not only this one");
}

CLI::Option* addNumber(CLI::App& command, const std::string& flag, double& number, double least, double most,
                       const std::string& shape, const std::string& help) {
  return addParsed(command, flag, number, within(least, most), shape, help);
}

CLI::Option* addWhole(CLI::App& command, const std::string& flag, std::uint64_t& number,
                      const std::string& help) {
  return addWhole(command, flag, number, 0, std::numeric_limits<std::uint64_t>::max(), help);
}

CLI::Option* addWholeInto(CLI::App& command, const std::string& flag,
                          const std::function<void(std::uint64_t)>& keep, std::uint64_t least,
                          std::uint64_t most, const std::string& help) {
  const auto read = [=](const std::string& text) {
    const Expected<std::uint64_t> whole = parseWhole(text, least, most);
    if (!whole) throw CLI::ValidationError(flag, whole.error().message);
    keep(*whole);
  };
  return command.add_option_function<std::string>(flag, read, help)->type_name("N");
}

void addSeed(CLI::App& command, std::uint64_t& seed) {
  addWhole(command, "--seed", seed, "Of the roadmap's random numbers (1)");
}

void addRoadmap(CLI::App& command, std::string& file) {
  command
      .add_option("--roadmap", file, "Keep the roadmap in this file: load it if it fits, save what has grown")
      ->type_name("FILE");
}

Expected<Request> requestOf(const QueryArguments& arguments, const Robot& robot) {
  if (!arguments.start) return fail(ErrorCode::kInvalidRequest, "--start is missing; give x,y,yaw");
  if (arguments.goals.empty())
    return fail(ErrorCode::kInvalidRequest, "--goal is missing; give x,y or x,y,yaw");
  const Expected<ModeId> start_mode = modeOf(arguments.start_mode, "--start-mode", robot);
  if (!start_mode) return tl::unexpected(start_mode.error());
  const Expected<ModeId> goal_mode = modeOf(arguments.goal_mode, "--goal-mode", robot);
  if (!goal_mode) return tl::unexpected(goal_mode.error());
  Request request;
  request.start = *arguments.start;
  request.start_mode = *start_mode;
  request.policy = arguments.policy;
  request.max_detour = arguments.max_detour;
  std::vector<Goal> goals = arguments.goals;
  for (Goal& goal : goals) goal.mode = *goal_mode;
  return withGoals(std::move(request), goals);
}

}  // namespace underway
