#include <unistd.h>

#include <atomic>
#include <memory>
#include <thread>

#include "apps/commands.hpp"
#include "apps/driving.hpp"
#include "apps/journey.hpp"
#include "apps/journey_line.hpp"
#include "apps/replay.hpp"
#include "apps/stand_in.hpp"
#include "apps/stop_signals.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "local/drivable.hpp"
#include "planner/planner.hpp"
#include "server/change_service.hpp"
#include "server/plan_service.hpp"
#include "server/robot/follower.hpp"
#include "server/robot/remote_plans.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway run --map maps/scenario3.yaml --html run.html\n"
    "  underway run --map maps/scenario3.yaml --query under_the_table --unmapped "
    "box=1.6,2.4,0.2,0.3,0.3,0.4\n"
    "  underway run --map maps/flat.yaml --start 1,1,0 --goal 5,4 --seed 7 --noise 2 --rate 1\n"
    "Server, follower and simulated robot talk over DDS, among themselves alone. Each tick waits for its "
    "command, so\n"
    "that the same seed gives the same run.\n"
    "Exit codes: 0 arrived and touched nothing, 3 there is no way, 2 invalid input, 1 it touched something "
    "or needs\n"
    "help, or anything else.";

constexpr const char* kName = "robot";

struct Arguments {
  MapArguments map;
  std::string robot;
  QueryArguments query;
  std::string query_name;
  TruthArguments truth;
  double rate = 0.0;
  double limit_s = 1800.0;
  std::string html;
};

/// All that a run is about.
struct Course {
  Site site;
  std::shared_ptr<const World> truth;
  Request request;
};

/// The query that was named, or the words', or else the map's first that has an answer.
Expected<Request> requestOf(const Arguments& arguments, const Site& site) {
  std::string name = arguments.query_name;
  if (name.empty() && !arguments.query.start && arguments.query.goals.empty())
    for (const Query& query : site.queries)
      if (name.empty() && query.expect == "ok") name = query.name;
  Expected<QueryArguments> query = arguments.query;
  if (!name.empty()) query = queryNamed(name, site.queries, arguments.query);
  if (!query) return tl::unexpected(query.error());
  return underway::requestOf(*query, *site.robot);
}

Expected<Course> courseOf(const Arguments& arguments) {
  Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  if (const auto drivable = checkDrivable(*site->robot); !drivable) return tl::unexpected(drivable.error());
  const auto truth = truthOf(arguments.truth, *site);
  if (!truth) return tl::unexpected(truth.error());
  const auto request = requestOf(arguments, *site);
  if (!request) return tl::unexpected(request.error());
  if (const auto free = checkStart(*truth, site->robot, request->start_mode, request->start); !free)
    return tl::unexpected(free.error());
  return Course{std::move(*site), *truth, *request};
}

/// The server's side: a planner with its roadmap, and what answers for it.
struct Serving {
  PlanService plans;
  ChangeService changes;
};

Expected<Serving> serve(const std::shared_ptr<const Domain>& domain, const Site& site,
                        const std::stop_token& stop) {
  constexpr std::chrono::seconds kMostGrowth{30};
  const auto planner = std::make_shared<Planner>(site.world, site.robot);
  {
    ProgressBar bar("growing the roadmap");
    planner->prepare(
        Planner::Clock::now() + kMostGrowth, [&](double share) { bar.show(share); }, stop);
  }
  const Served served{*site.robot, site.world->name(), hashOf(*site.robot), GrowthSettings{}.seed};
  auto plans = PlanService::start(domain, served, handlerFor(planner));
  if (!plans) return tl::unexpected(plans.error());
  auto changes = ChangeService::start(domain, planner);
  if (!changes) return tl::unexpected(changes.error());
  return Serving{std::move(*plans), std::move(*changes)};
}

/// The robot's side, on a thread of its own until it is told to stop.
class Body {
 public:
  Body(const Course& course, const Arguments& arguments, std::unique_ptr<RobotEnd> end, std::stop_source stop)
      : robot_(course.truth, course.site.robot, course.request.start, course.request.start_mode,
               arguments.truth.seed, arguments.truth.flaws()),
        stand_in_(robot_, std::move(end), {true, arguments.rate}),
        track_(course.truth, course.site.robot),
        limit_s_(arguments.limit_s),
        stop_(std::move(stop)),
        thread_([this] { live(); }) {}

  ~Body() { join(); }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  /// Ends it.
  void join() {
    stop_.request_stop();
    if (thread_.joinable()) thread_.join();
  }
  /// After join().
  [[nodiscard]] const sim::SimulatedRobot& robot() const { return robot_; }
  [[nodiscard]] const TrueTrack& track() const { return track_; }
  [[nodiscard]] const Expected<void>& lived() const { return lived_; }

 private:
  void live() {
    lived_ =
        stand_in_.live(stop_.get_token(), [this](std::uint64_t tick, const sim::SimulatedRobot& body, bool) {
          track_.add(tick, body);
          if (body.truth().has_collided || body.now_s() > limit_s_) stop_.request_stop();
        });
    if (!lived_) stop_.request_stop();
  }

  sim::SimulatedRobot robot_;
  StandIn stand_in_;
  TrueTrack track_;
  double limit_s_;
  std::stop_source stop_;
  Expected<void> lived_;
  std::thread thread_;
};

/// What came of a run.
struct Ran {
  Course course;
  JourneyEnd end;
  Journal journal;
  OwnTrack own_track;
  TrueTrack true_track;
  sim::Truth truth;
};

std::string outcomeOf(const Ran& ran) {
  std::string text = "The robot " + describe(ran.end, ran.journal) + "; went ";
  text += fixed(ran.truth.moved_m, 2) + " m, touched ";
  text += (ran.truth.has_collided ? printable(ran.truth.with) : "nothing") + ", least clearance ";
  return text + fixed(ran.true_track.leastClearance(), 3) + " m.";
}

/// Everyone who talks, before the first word.
struct Stage {
  std::shared_ptr<const Domain> domain;
  Serving serving;
  RemotePlans plans;
  std::unique_ptr<RobotEnd> robot_end;
  std::unique_ptr<DriverEnd> driver_end;
};

Expected<Stage> setStage(const Site& site, const Arguments& arguments, const std::stop_token& stop) {
  const auto domain = Domain::open({.tag = "underway-run-" + std::to_string(getpid())});
  if (!domain) return tl::unexpected(domain.error());
  auto serving = serve(*domain, site, stop);
  if (!serving) return tl::unexpected(serving.error());
  auto plans = RemotePlans::open(*domain, kName, site.world, site.robot, {arguments.query.deadline, {}});
  if (!plans) return tl::unexpected(plans.error());
  auto robot_end = openRobotEnd(**domain, kName, site.robot);
  if (!robot_end) return tl::unexpected(robot_end.error());
  auto driver_end = openDriverEnd(**domain, kName, site.robot);
  if (!driver_end) return tl::unexpected(driver_end.error());
  return Stage{*domain, std::move(*serving), std::move(*plans), std::move(*robot_end),
               std::move(*driver_end)};
}

/// What the journey ended by, if it did not end by itself.
JourneyEnd judged(JourneyEnd end, const sim::SimulatedRobot& body, double limit_s) {
  const sim::Truth& truth = body.truth();
  if (truth.has_collided) return {Mission::Outcome::kNeedsHelp, "it touched " + truth.with};
  if (end.outcome == Mission::Outcome::kUnderway && body.now_s() > limit_s)
    end.why = "it had " + fixed(limit_s, 0) + " s";
  return end;
}

Expected<Ran> drive(const Arguments& arguments, const StopSignals& signals) {
  const auto course = courseOf(arguments);
  if (!course) return tl::unexpected(course.error());
  std::stop_source stop;
  const std::stop_callback by_signal(signals.token(), [&] { stop.request_stop(); });
  auto stage = setStage(course->site, arguments, stop.get_token());
  if (!stage) return tl::unexpected(stage.error());

  Body body(*course, arguments, std::move(stage->robot_end), stop);
  Journal journal;
  OwnTrack own_track;
  JourneyLine line(*course->site.robot);
  Follower follower(std::move(stage->driver_end), {.is_in_step = true});
  const auto source = [&](const Request& asked, const std::shared_ptr<const World>& world) {
    return stage->plans.plan(asked, *world);
  };
  const auto watch = [&](const Mission& mission, const Tick& tick, const HeardSenses& heard) {
    own_track.add(mission, tick.state, heard);
    line.show(journal.tick(mission), mission, tick.state);
  };
  const auto end = follower.drive(course->site.world, course->site.robot, course->request, source,
                                  stop.get_token(), watch);
  body.join();
  if (!body.lived()) return tl::unexpected(body.lived().error());
  if (!end) return tl::unexpected(end.error());
  const JourneyEnd last = judged(*end, body.robot(), arguments.limit_s);
  return Ran{*course, last, journal, std::move(own_track), body.track(), body.robot().truth()};
}

Expected<void> writeReplay(const Ran& ran, const std::string& file) {
  const Course& course = ran.course;
  const std::string title = course.site.robot->name + " in " + course.site.world->name();
  return writeText(file, replayPage({title, outcomeOf(ran), *course.site.world, *course.truth,
                                     *course.site.robot, course.request, ran.true_track, ran.own_track}));
}

ExitCode run(const Arguments& arguments) {
  const StopSignals signals;
  const Expected<Ran> ran = drive(arguments, signals);
  if (!ran) {
    complain(ran.error().message);
    return exitCodeOf(ran.error().code);
  }
  Expected<void> written = writeOutput(outcomeOf(*ran) + "\n");
  if (written && !arguments.html.empty()) written = writeReplay(*ran, arguments.html);
  if (written) return exitCodeOf(ran->end);
  complain(written.error().message);
  return ExitCode::kOther;
}

}  // namespace

Subcommand addRunCommand(CLI::App& program) {
  CLI::App& command =
      *program.add_subcommand("run", "Server, follower and simulated robot together, to look at");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addQuery(command, arguments->query);
  addQueryName(command, arguments->query_name);
  addTruth(command, arguments->truth);
  addRate(command, arguments->rate, "Simulated seconds in a second (as many as there can be)");
  addNumber(command, "--limit-s", arguments->limit_s, 1.0, 86400.0, "S",
            "Simulated seconds after which it is given up (1800)");
  addOutputFile(command, "--html", arguments->html, "FILE", "Write a page that shows the run again");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
