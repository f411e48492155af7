#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <array>
#include <filesystem>
#include <memory>
#include <system_error>

#include "apps/commands.hpp"
#include "apps/inputs.hpp"
#include "apps/plan_table.hpp"
#include "apps/roadmap_store.hpp"
#include "apps/stop_signals.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "planner/planner.hpp"
#include "server/change_service.hpp"
#include "server/client.hpp"
#include "server/plan_service.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway serve --map maps/scenario3.yaml\n"
    "  underway serve --map maps/ros/office.yaml --robot nao --domain 7 --workers 4 --ready-file /tmp/ready\n"
    "  underway serve --map maps/flat.yaml --roadmap flat.roadmap\n"
    "Prints 'ready' once it answers. Ends with SIGINT or SIGTERM. Its world is changed by 'underway change'.";

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

std::string textOf(const Goal& goal) {
  const std::string text = shortText(Pose{goal.at.x, goal.at.y, goal.yaw.value_or(0.0)});
  return goal.yaw ? text : text + " (any yaw)";
}

/// What became of a request, in a line.
std::string outcomeOf(const Asked& asked, const Expected<Given>& given) {
  if (!given)
    return std::string(name(given.error().code)) + " in revision " + std::to_string(given.error().revision);
  const Plan& plan = given->plan;
  std::string text = "ok in revision " + std::to_string(plan.revision) + ", " + fixed(plan.total_time_s, 1) +
                     " s, " + std::to_string(plan.segments.size()) + " segments";
  if (!asked.request.other_goals.empty()) text += " to goal " + std::to_string(plan.goal_index + 1);
  if (given->choice) text += given->choice->is_new ? ", a new plan" : ", the one followed";
  return text;
}

std::string lineOf(const Asked& asked, const Robot& robot, const Expected<Given>& given, double took_ms) {
  constexpr std::array kPurposes{"", "replan ", "check "};
  const Request& request = asked.request;
  const std::vector<Goal> goals = goalsOf(request);
  std::string line = kPurposes[static_cast<std::size_t>(asked.purpose)] + std::string(name(request.policy)) +
                     " " + robot.modes[request.start_mode].name + " " + shortText(request.start) + " -> " +
                     robot.modes[request.goal_mode].name + " " + textOf(goals.front());
  if (goals.size() > 1) line += " or " + std::to_string(goals.size() - 1) + " other goals";
  return line + ": " + outcomeOf(asked, given) + ", took " + fixed(took_ms, 2) + " ms";
}

/// The planner's answers, each told in the log.
PlanHandler loggedHandlerFor(const std::shared_ptr<Planner>& planner,
                             const std::shared_ptr<const Robot>& robot,
                             const std::shared_ptr<spdlog::logger>& log) {
  return [robot, log, handler = handlerFor(planner)](const Asked& asked, Planner::Clock::time_point deadline,
                                                     const std::stop_token& stop) {
    const auto start = Planner::Clock::now();
    Expected<Given> given = handler(asked, deadline, stop);
    const std::chrono::duration<double, std::milli> took = Planner::Clock::now() - start;
    log->info("{}", printable(lineOf(asked, *robot, given, took.count())));
    return given;
  };
}

ChangeService::Log changeLog(const std::shared_ptr<spdlog::logger>& log) {
  return [log](std::size_t changes, const World& world, const Expected<Changed>& outcome) {
    if (outcome)
      log->info("{} changes: the world is at revision {} now, {} ways closed, {} opened", changes,
                world.revision(), outcome->repair.closed, outcome->repair.opened);
    else
      log->info("{} changes refused: {}", changes, printable(outcome.error().message));
  };
}

Served servedBy(const Site& site, std::uint64_t seed) {
  return {*site.robot, site.world->name(), hashOf(*site.robot), seed};
}

/// Grows the roadmap, so that the first request finds it ready.
void prepare(Planner& planner, std::chrono::milliseconds most, const std::stop_token& stop) {
  ProgressBar bar("growing the roadmap");
  planner.prepare(
      Planner::Clock::now() + most, [&](double share) { bar.show(share); }, stop);
}

/// Looks whether another server answers in the domain. It is no reason to refuse: one that was killed stays
/// there for a moment.
class Lookout {
 public:
  /// Begins to discover, which takes a moment.
  [[nodiscard]] static Expected<Lookout> open(const std::shared_ptr<const Domain>& domain) {
    Expected<PlanClient> client = PlanClient::open(domain);
    if (!client) return tl::unexpected(client.error());
    return Lookout(std::move(*client));
  }
  /// Before a service of our own is there to be seen.
  void tell(spdlog::logger& log, std::uint32_t domain) {
    if (client_.findServer(began_ + kDiscovery))
      log.warn(
          "another server answers in DDS domain {}, or did until a moment ago: while both do, a question "
          "gets "
          "the answer of one of them, whichever; stop one, or give --domain",
          domain);
  }

 private:
  static constexpr std::chrono::milliseconds kDiscovery{300};  // of which growing takes most
  explicit Lookout(PlanClient client) : client_(std::move(client)) {}
  PlanClient client_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// Says that the server answers, by a file that is there for as long as it does. One that an earlier server
/// has left goes first; anything else of that name stays until it is written over.
class ReadyFile {
 public:
  explicit ReadyFile(std::string file) : file_(std::move(file)) { remove(); }
  ~ReadyFile() { remove(); }
  ReadyFile(const ReadyFile&) = delete;
  ReadyFile& operator=(const ReadyFile&) = delete;

  [[nodiscard]] Expected<void> announce() const {
    const Expected<void> written = file_.empty() ? Expected<void>{} : writeText(file_, kReady);
    return written ? writeOutput(kReady) : written;
  }

 private:
  static constexpr const char* kReady = "ready\n";

  void remove() const {
    std::error_code error;
    if (file_.empty() || !std::filesystem::is_regular_file(file_, error)) return;
    if (const Expected<std::string> text = readText(file_); text && *text == kReady)
      std::filesystem::remove(file_, error);
  }

  std::string file_;
};

Expected<void> serve(const Arguments& arguments, const StopSignals& signals) {
  const ReadyFile ready(arguments.ready_file);
  const Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  const auto domain = Domain::open(arguments.domain);
  if (!domain) return tl::unexpected(domain.error());

  auto lookout = Lookout::open(*domain);  // discovers while the roadmap grows
  if (!lookout) return tl::unexpected(lookout.error());
  const auto log =
      std::make_shared<spdlog::logger>("underway", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  const auto planner = std::make_shared<Planner>(site->world, site->robot, arguments.growth);
  RoadmapStore store(arguments.roadmap_file);
  store.loadInto(*planner);
  prepare(*planner, std::chrono::milliseconds(arguments.prepare_ms), signals.token());
  store.saveFrom(*planner);
  if (signals.token().stop_requested()) return {};
  lookout->tell(*log, arguments.domain.id);

  Expected<PlanService> service =
      PlanService::start(*domain, servedBy(*site, arguments.growth.seed),
                         loggedHandlerFor(planner, site->robot, log), arguments.service);
  if (!service) return tl::unexpected(service.error());
  Expected<ChangeService> changes = ChangeService::start(*domain, planner, changeLog(log));
  if (!changes) return tl::unexpected(changes.error());
  const std::stop_callback stop_services(signals.token(), [&] {
    service->stop();
    changes->stop();
  });
  const auto roadmap = planner->roadmap();
  log->info("serving map {} for robot {} in domain {}: {} nodes, {} edges", printable(site->world->name()),
            printable(site->robot->name), arguments.domain.id, roadmap->node_count, roadmap->edge_count);
  if (const Expected<void> announced = ready.announce(); !announced) return announced;
  Expected<void> served = service->wait();
  changes->stop();
  if (const Expected<void> changed = changes->wait(); served && !changed) served = changed;
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

Subcommand addServeCommand(CLI::App& program) {
  constexpr std::uint64_t kDay_ms = 86'400'000;
  CLI::App& command = *program.add_subcommand("serve", "Answer plan requests over DDS until told to stop");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addDomain(command, arguments->domain);
  addWhole(command, "--workers", arguments->service.threads, 1, 256,
           "Threads that plan (as many as the machine has)");
  addSeed(command, arguments->growth.seed);
  addRoadmap(command, arguments->roadmap_file);
  addWhole(command, "--prepare-ms", arguments->prepare_ms, 0, kDay_ms,
           "Longest time for growing the roadmap at first (30000)");
  addOutputFile(command, "--ready-file", arguments->ready_file, "FILE",
                "Write this file once it answers, and remove it when it ends");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
