#include <memory>

#include "apps/commands.hpp"
#include "apps/driving.hpp"
#include "apps/journey.hpp"
#include "apps/journey_line.hpp"
#include "apps/stop_signals.hpp"
#include "apps/terminal.hpp"
#include "apps/wire.hpp"
#include "local/drivable.hpp"
#include "server/robot/follower.hpp"
#include "server/robot/remote_plans.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway serve --map maps/scenario3.yaml &\n"
    "  underway sim --map maps/scenario3.yaml --start 0.6,2,0 &\n"
    "  underway follow --map maps/scenario3.yaml --goal 5.4,2,0\n"
    "  underway follow --map maps/scenario3.yaml --goal 5.4,2 --policy safest --name nao_2\n"
    "  underway follow --map maps/office.yaml --goal 3,1 --ros --network --odom-topic amcl_odom\n"
    "Where the robot is it tells itself; --start is for one that has no localisation. Ctrl-C has it stand "
    "still.\n"
    "Exit codes: 0 arrived, 3 there is no way, 4 no server, 2 invalid input, 1 it needs help, or anything "
    "else.";

struct Arguments {
  MapArguments map;
  std::string robot;
  QueryArguments query;
  std::string query_name;
  WireArguments wire;
  double robot_timeout_s = 5.0;
  double server_timeout_s = 30.0;
};

FollowerSettings settingsOf(const Arguments& arguments) {
  FollowerSettings settings;
  settings.robot_timeout = std::chrono::milliseconds(std::lround(1000.0 * arguments.robot_timeout_s));
  settings.server_silent = std::chrono::seconds(std::lround(arguments.server_timeout_s));
  return settings;
}

/// What is asked for, from where the robot says it is.
Expected<Request> requestFrom(const Met& met, const Arguments& arguments, const Site& site) {
  Expected<QueryArguments> query = arguments.query;
  if (!arguments.query_name.empty()) query = queryNamed(arguments.query_name, site.queries, arguments.query);
  if (!query) return tl::unexpected(query.error());
  if (met.pose && !arguments.query.start) query->start = met.pose;
  if (!query->start)
    return fail(ErrorCode::kInvalidRequest, "the robot does not tell where it is; give --start x,y,yaw");
  if (arguments.query.start_mode.empty()) query->start_mode = site.robot->modes[met.mode].name;
  return requestOf(*query, *site.robot);
}

Expected<JourneyEnd> follow(const Arguments& arguments, const StopSignals& signals, Journal& journal) {
  const Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  if (const auto drivable = checkDrivable(*site->robot); !drivable) return tl::unexpected(drivable.error());
  // What can be wrong with the words is told before anyone is looked for.
  if (const auto sound = requestFrom({Pose{}, 0}, arguments, *site); !sound)
    return tl::unexpected(sound.error());
  const auto domain = Domain::open(arguments.wire.domain);
  if (!domain) return tl::unexpected(domain.error());
  auto end = openDriverEnd(arguments.wire, **domain, site->robot);
  if (!end) return tl::unexpected(end.error());
  auto plans = RemotePlans::open(*domain, arguments.wire.name, site->world, site->robot,
                                 {arguments.query.deadline, {}});
  if (!plans) return tl::unexpected(plans.error());

  Follower follower(std::move(*end), settingsOf(arguments));
  const auto met = follower.meet(signals.token());
  if (!met) return tl::unexpected(met.error());
  const Expected<Request> request = requestFrom(*met, arguments, *site);
  if (!request) return tl::unexpected(request.error());
  JourneyLine line(*site->robot);
  const auto source = [&](const Request& asked, const std::shared_ptr<const World>& world) {
    return plans->plan(asked, *world);
  };
  auto ended = follower.drive(site->world, site->robot, *request, source, signals.token(),
                              [&](const Mission& mission, const Tick& tick, const HeardSenses&) {
                                line.show(journal.tick(mission), mission, tick.state);
                              });
  plans->forget();
  return ended;
}

ExitCode run(const Arguments& arguments) {
  const StopSignals signals;
  Journal journal;
  const Expected<JourneyEnd> ended = follow(arguments, signals, journal);
  return deliverJourney(ended, journal);
}

}  // namespace

Subcommand addFollowCommand(CLI::App& program) {
  CLI::App& command =
      *program.add_subcommand("follow", "Drive a robot to a goal by a server's plans, over DDS");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addQuery(command, arguments->query);
  addQueryName(command, arguments->query_name);
  addWire(command, arguments->wire);
  addNumber(command, "--robot-timeout-s", arguments->robot_timeout_s, 0.1, 3600.0, "S",
            "How long to listen for the robot (5)");
  addNumber(command, "--server-timeout-s", arguments->server_timeout_s, 1.0, 86400.0, "S",
            "How long to stand and wait for a server that went away (30)");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
