#include <memory>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/draw_svg.hpp"
#include "apps/inputs.hpp"
#include "apps/terminal.hpp"
#include "server/client.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2,0\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2 --policy safest --json plan.json\n"
    "  underway ask --start 0.6,2,0 --goal 5.4,2 --svg plan.svg --map maps/scenario3.yaml\n"
    "Exit codes: 0 a plan, 3 a valid 'no', 2 invalid input, 4 no server, 1 anything else.";

struct Arguments {
  std::string robot_name = "nao";
  DomainSettings domain;
  QueryArguments query;
  OutputArguments output;
  MapArguments map;   ///< of the picture
  std::string robot;  ///< of the picture
};

Question questionOf(const Arguments& arguments) {
  const QueryArguments& query = arguments.query;
  return {arguments.robot_name, *query.start, query.start_mode, query.goal->at, query.goal->yaw,
          query.goal_mode,      query.policy, query.max_detour, query.deadline};
}

Expected<PlanDocument> askServer(const Arguments& arguments) {
  const auto domain = Domain::open(arguments.domain);
  if (!domain) return tl::unexpected(domain.error());
  Expected<PlanClient> client = PlanClient::open(*domain);
  if (!client) return tl::unexpected(client.error());
  return client->ask(questionOf(arguments));
}

/// A picture draws the server's modes with the bodies of a local robot file: they must be the same modes.
bool hasModesOf(const PlanDocument& document, const Robot& robot) {
  if (document.mode_names.size() != robot.modes.size()) return false;
  for (std::size_t i = 0; i < robot.modes.size(); ++i)
    if (robot.modes[i].name != document.mode_names[i]) return false;
  return true;
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
  if (!hasModesOf(*reply, *site.robot)) {
    complain("--svg: the server's robot \"" + reply->robot_name + "\" has other modes than robot \"" +
             site.robot->name + "\"; give --robot the file that the server uses");
    return ExitCode::kInvalidInput;
  }
  return deliver(*reply, arguments.output, [&] {
    return drawSvg({*site.world, *site.robot, nullptr, &*reply});
  });
}

}  // namespace

Command addAskCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("ask", "Ask a server for a plan, over DDS");
  const auto arguments = std::make_shared<Arguments>();
  addQuery(command, arguments->query);
  command.get_option("--start")->required();
  command.get_option("--goal")->required();
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
