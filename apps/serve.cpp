#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "apps/commands.hpp"
#include "apps/inputs.hpp"
#include "apps/plan_table.hpp"
#include "apps/roadmap_store.hpp"
#include "apps/stop_signals.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "planner/planner.hpp"
#include "server/plan_service.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway serve --map maps/scenario3.yaml\n"
    "  underway serve --map maps/ros/office.yaml --robot nao --domain 7 --workers 4 --ready-file /tmp/ready\n"
    "  underway serve --map maps/flat.yaml --roadmap flat.roadmap\n"
    "Prints 'ready' once it answers. Ends with SIGINT or SIGTERM.";

struct Arguments {
  MapArguments map;
  std::string robot;
  DomainSettings domain;
  PlanServiceSettings service;
  GrowthSettings growth;
  std::uint32_t prepare_ms = 30'000;
  std::string ready_file;
  std::string roadmap_file;
};

std::string lineOf(const Request& request, const Robot& robot, const Expected<Plan>& plan, double took_ms) {
  const Pose goal{request.goal.x, request.goal.y, request.goal_yaw.value_or(0.0)};
  std::string line = std::string(name(request.policy)) + " " + robot.modes[request.start_mode].name + " " +
                     shortText(request.start) + " -> " + robot.modes[request.goal_mode].name + " " +
                     shortText(goal);
  if (!request.goal_yaw) line += " (any yaw)";
  line += plan ? ": ok, " + fixed(plan->total_time_s, 1) + " s, " + std::to_string(plan->segments.size()) +
                     " segments"
               : ": " + std::string(name(plan.error().code));
  return line + ", took " + fixed(took_ms, 2) + " ms";
}

PlanHandler handlerFor(const std::shared_ptr<Planner>& planner, const std::shared_ptr<const Robot>& robot,
                       const std::shared_ptr<spdlog::logger>& log) {
  return [=](const Request& request, Planner::Clock::time_point deadline, std::stop_token stop) {
    const auto start = Planner::Clock::now();
    Expected<Plan> plan = planner->plan(request, deadline, std::move(stop));
    const std::chrono::duration<double, std::milli> took = Planner::Clock::now() - start;
    log->info("{}", printable(lineOf(request, *robot, plan, took.count())));
    return plan;
  };
}

Served servedBy(const Site& site, std::uint64_t seed) {
  return {*site.robot,        site.world->name(),  site.world->revision(),
          site.world->hash(), hashOf(*site.robot), seed};
}

/// Grows the roadmap, so that the first request finds it ready.
void prepare(Planner& planner, std::chrono::milliseconds most, const std::stop_token& stop) {
  ProgressBar bar("growing the roadmap");
  planner.prepare(
      Planner::Clock::now() + most, [&](double share) { bar.show(share); }, stop);
}

Expected<void> announce(const std::string& ready_file) {
  if (const Expected<void> written = writeOutput("ready\n"); !written) return written;
  return ready_file.empty() ? Expected<void>{} : writeText(ready_file, "ready\n");
}

Expected<void> serve(const Arguments& arguments, const StopSignals& signals) {
  const Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  const auto domain = Domain::open(arguments.domain);
  if (!domain) return tl::unexpected(domain.error());

  const auto log =
      std::make_shared<spdlog::logger>("underway", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  const auto planner = std::make_shared<Planner>(site->world, site->robot, arguments.growth);
  RoadmapStore store(arguments.roadmap_file);
  store.loadInto(*planner);
  prepare(*planner, std::chrono::milliseconds(arguments.prepare_ms), signals.token());
  store.saveFrom(*planner);
  if (signals.token().stop_requested()) return {};

  Expected<PlanService> service =
      PlanService::start(*domain, servedBy(*site, arguments.growth.seed),
                         handlerFor(planner, site->robot, log), arguments.service);
  if (!service) return tl::unexpected(service.error());
  const std::stop_callback stop_service(signals.token(), [&] { service->stop(); });
  const auto roadmap = planner->roadmap();
  log->info("serving map {} for robot {} in domain {}: {} nodes, {} edges", printable(site->world->name()),
            printable(site->robot->name), arguments.domain.id, roadmap->node_count, roadmap->edge_count);
  if (const Expected<void> announced = announce(arguments.ready_file); !announced) return announced;
  Expected<void> served = service->wait();
  store.saveFrom(*planner);  // what requests have made it grow
  return served;
}

ExitCode run(const Arguments& arguments) {
  const StopSignals signals;
  const Expected<void> served = serve(arguments, signals);
  if (served) return ExitCode::kDone;
  complain(served.error().message);
  return exitCodeOf(served.error().code);
}

}  // namespace

Command addServeCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("serve", "Answer plan requests over DDS until told to stop");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addDomain(command, arguments->domain);
  command
      .add_option("--workers", arguments->service.threads, "Threads that plan (as many as the machine has)")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  addSeed(command, arguments->growth.seed);
  addRoadmap(command, arguments->roadmap_file);
  command
      .add_option("--prepare-ms", arguments->prepare_ms,
                  "Longest time for growing the roadmap at first (30000)")
      ->type_name("N");
  command.add_option("--ready-file", arguments->ready_file, "Write this file once it answers")
      ->type_name("FILE");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
