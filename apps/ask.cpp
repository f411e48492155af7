#include <memory>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/draw_svg.hpp"
#include "apps/inputs.hpp"
#include "apps/rivals.hpp"
#include "apps/terminal.hpp"
#include "server/client.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2,0\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2 --policy safest --json plan.json\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2 --svg plan.svg --map maps/scenario3.yaml\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2 --goal 5.4,0.8,1.57     # to the best of two goals\n"
    "  underway ask --stale plan.json --segment 3                        # may the plan still be followed?\n"
    "  underway ask --replan plan.json --segment 3 --done 0.4 --json plan.json\n"
    "Exit codes: 0 a plan, or it may still be followed, 3 a valid 'no', 2 invalid input, 4 no server, 1 "
    "anything else.";

struct Arguments {
  std::string robot_name = "nao";
  DomainSettings domain;
  QueryArguments query;
  FollowArguments follow;
  OutputArguments output;
  MapArguments map;   ///< of the picture
  std::string robot;  ///< of the picture, and of a plan that is followed
};

/// What was asked on the command line alone.
Expected<Question> plainQuestion(const QueryArguments& query) {
  if (!query.start) return fail(ErrorCode::kInvalidRequest, "--start is missing; give x,y,yaw");
  if (query.goals.empty()) return fail(ErrorCode::kInvalidRequest, "--goal is missing; give x,y or x,y,yaw");
  Question question;
  question.start = *query.start;
  question.start_mode = query.start_mode;
  question.goal = query.goals.front().at;
  question.goal_yaw = query.goals.front().yaw;
  question.goal_mode = query.goal_mode;
  for (std::size_t i = 1; i < query.goals.size(); ++i)
    question.other_goals.push_back({query.goals[i].at, query.goals[i].yaw, query.goal_mode});
  question.policy = query.policy;
  question.max_detour = query.max_detour;
  return question;
}

/// What is asked about a plan that is being followed.
Expected<Question> questionAbout(const FollowedPlan& followed, const Arguments& arguments,
                                 const Robot& robot) {
  const auto named = [&](ModeId mode) { return robot.modes[mode].name; };
  const Request request = requestOf(followed, arguments.query, robot);
  Question question;
  question.start = request.start;
  question.start_mode = named(request.start_mode);
  question.goal = request.goal;
  question.goal_yaw = request.goal_yaw;
  question.goal_mode = named(request.goal_mode);
  for (const Goal& goal : request.other_goals)
    question.other_goals.push_back({goal.at, goal.yaw, named(goal.mode)});
  question.policy = request.policy;
  question.max_detour = request.max_detour;
  question.purpose = arguments.follow.stale.empty() ? Purpose::kReplan : Purpose::kCheck;
  question.followed = {followed.executing, followed.document.mode_names, arguments.follow.gain};
  return question;
}

Expected<Question> questionOf(const Arguments& arguments) {
  if (!arguments.follow.isGiven()) return plainQuestion(arguments.query);
  const auto file = findRobotFile(arguments.robot);
  if (!file) return tl::unexpected(file.error());
  const Expected<Robot> robot = readRobot(*file);
  if (!robot) return tl::unexpected(robot.error());
  const Expected<FollowedPlan> followed = readFollowed(arguments.follow, *robot);
  if (!followed) return tl::unexpected(followed.error());
  return questionAbout(*followed, arguments, *robot);
}

Expected<PlanDocument> askServer(const Arguments& arguments) {
  Expected<Question> question = questionOf(arguments);
  if (!question) return tl::unexpected(question.error());
  question->robot = arguments.robot_name;
  question->deadline = arguments.query.deadline;
  const auto domain = Domain::open(arguments.domain);
  if (!domain) return tl::unexpected(domain.error());
  Expected<PlanClient> client = PlanClient::open(*domain);
  if (!client) return tl::unexpected(client.error());
  Expected<PlanDocument> reply = client->ask(*question);
  if (reply) complainOfRivals(client->servers(), arguments.domain.id);
  return reply;
}

/// A picture draws the server's modes with the bodies of a local robot file: they must be the same modes.
bool hasModesOf(const PlanDocument& document, const Robot& robot) {
  if (document.mode_names.size() != robot.modes.size()) return false;
  for (std::size_t i = 0; i < robot.modes.size(); ++i)
    if (robot.modes[i].name != document.mode_names[i]) return false;
  return true;
}

/// Why the answer cannot be drawn into this map, with this robot; empty if it can.
std::string refusalOf(const PlanDocument& reply, const Site& site) {
  if (!hasModesOf(reply, *site.robot))
    return "--svg: the server's robot \"" + reply.robot_name + "\" has other modes than robot \"" +
           site.robot->name + "\"; give --robot the file that the server uses";
  if (reply.map_name != site.world->name())
    return "--svg: the server's map is \"" + reply.map_name + "\", not \"" + site.world->name() +
           "\"; give --map the file that the server uses";
  return {};
}

/// In what the picture is not of what the server has, though of one name; empty if it is.
std::string differenceOf(const PlanDocument& reply, const Site& site) {
  std::string what;
  if (!reply.world_hash.empty() && reply.world_hash != site.world->hash()) what = "world";
  if (!reply.robot_hash.empty() && reply.robot_hash != hashOf(*site.robot))
    what += what.empty() ? "robot" : " and robot";
  if (what.empty()) return {};
  return "--svg: the server has another version of the " + what + " than the picture shows";
}

ExitCode run(const Arguments& arguments) {
  PlanDocument document = documentOf(arguments.query);
  const auto refuse = [&](const Error& error) {
    document.answer = tl::unexpected(error);
    return deliver(document, arguments.output, {});
  };
  Site site;
  if (!arguments.output.svg.empty()) {
    Expected<Site> read = readSite(arguments.map, arguments.robot);
    if (!read) return refuse(read.error());
    site = std::move(*read);
  }
  const Expected<PlanDocument> reply = askServer(arguments);
  if (!reply) return refuse(reply.error());
  if (!site.world) return deliver(*reply, arguments.output, {});
  if (const std::string refusal = refusalOf(*reply, site); !refusal.empty()) {
    const ExitCode delivered = deliver(*reply, arguments.output, {});  // all but the picture
    complain(refusal);
    return delivered == ExitCode::kDone ? ExitCode::kInvalidInput : delivered;
  }
  if (const std::string difference = differenceOf(*reply, site); !difference.empty()) complain(difference);
  return deliver(*reply, arguments.output, [&] {
    return drawSvg({*site.world, *site.robot, nullptr, &*reply});
  });
}

}  // namespace

Subcommand addAskCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("ask", "Ask a server for a plan, over DDS");
  const auto arguments = std::make_shared<Arguments>();
  addQuery(command, arguments->query);
  addReplan(command, arguments->follow);
  command.add_option("--stale", arguments->follow.stale, "Only ask whether this plan may still be followed")
      ->type_name("PLAN.json")
      ->excludes("--replan", "--start", "--start-mode", "--goal", "--goal-mode", "--policy");
  command.add_option("--robot-name", arguments->robot_name, "Who asks (nao)")->type_name("NAME");
  addDomain(command, arguments->domain);
  addOutput(command, arguments->output);
  addMap(command, arguments->map);
  addRobot(command, arguments->robot);
  command.get_option("--svg")->needs("--map");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
