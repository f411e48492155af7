#include <memory>

#include "apps/commands.hpp"
#include "apps/driving.hpp"
#include "apps/stand_in.hpp"
#include "apps/stop_signals.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "apps/wire.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway sim --map maps/scenario3.yaml --start 0.6,2,0\n"
    "  underway sim --map maps/flat.yaml --start 1,1,0 --unmapped box=2,1.1,0.2,0.3,0.3,0.4 --noise 2 --seed "
    "7\n"
    "  underway sim --map maps/scenario3.yaml --start 0.6,2,0 --ros     # as a ROS 2 robot\n"
    "Prints 'ready' once it tells its senses. Without a command for 0.5 s it stands still. Ends with SIGINT "
    "or\n"
    "SIGTERM and says whether it touched anything.\n"
    "Exit codes: 0 nothing was touched, 1 something was, 3 it cannot stand at its start, 2 invalid input.";

struct Arguments {
  MapArguments map;
  std::string robot;
  WireArguments wire;
  TruthArguments truth;
  std::optional<Pose> start;
  std::string start_mode;
  double rate = 1.0;
};

/// Tells on standard error what happens to the robot, each thing once.
class Witness {
 public:
  explicit Witness(const Robot& robot) : robot_(robot) {}

  void see(const sim::SimulatedRobot& body, bool is_silent) {
    const sim::Truth& truth = body.truth();
    if (truth.mode != mode_) say(body, "is in mode " + printable(robot_.modes[truth.mode].name));
    if (truth.has_collided && !has_collided_) say(body, "has touched " + printable(truth.with));
    if (is_silent && !is_silent_) say(body, "hears no commands: stands still");
    if (!is_silent && is_silent_) say(body, "hears commands");
    mode_ = truth.mode;
    has_collided_ = truth.has_collided;
    is_silent_ = is_silent;
  }

 private:
  static void say(const sim::SimulatedRobot& body, const std::string& what) {
    const Pose& at = body.truth().pose;
    complain(fixed(body.now_s(), 1) + " s: the robot at (" + fixed(at.x, 2) + " m, " + fixed(at.y, 2) +
             " m) " + what);
  }
  const Robot& robot_;
  ModeId mode_ = 0;
  bool has_collided_ = false;
  bool is_silent_ = true;
};

Expected<ExitCode> live(const Arguments& arguments, const StopSignals& signals) {
  const Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  const auto truth = truthOf(arguments.truth, *site);
  if (!truth) return tl::unexpected(truth.error());
  QueryArguments at;
  at.start = arguments.start;
  at.start_mode = arguments.start_mode;
  at.goals = {Goal{}};  // of no use here
  const Expected<Request> stand = requestOf(at, *site->robot);
  if (!stand) return tl::unexpected(stand.error());
  if (const auto free = checkStart(*truth, site->robot, stand->start_mode, stand->start); !free)
    return tl::unexpected(free.error());
  const auto domain = Domain::open(arguments.wire.domain);
  if (!domain) return tl::unexpected(domain.error());
  auto end = openRobotEnd(arguments.wire, **domain, site->robot);
  if (!end) return tl::unexpected(end.error());
  sim::SimulatedRobot body(*truth, site->robot, stand->start, stand->start_mode, arguments.truth.seed,
                           arguments.truth.flaws());
  StandIn stand_in(body, std::move(*end), {false, arguments.rate});
  if (const auto announced = writeOutput("ready\n"); !announced) return tl::unexpected(announced.error());
  Witness witness(*site->robot);
  const auto lived = stand_in.live(signals.token(), [&](std::uint64_t, const sim::SimulatedRobot& seen,
                                                        bool is_silent) { witness.see(seen, is_silent); });
  if (!lived) return tl::unexpected(lived.error());
  const sim::Truth& last = body.truth();
  const Pose& pose = last.pose;
  (void)writeOutput("At (" + fixed(pose.x, 3) + " m, " + fixed(pose.y, 3) + " m, " + fixed(pose.yaw, 3) +
                    " rad) in mode " + printable(site->robot->modes[last.mode].name) + " after " +
                    fixed(body.now_s(), 1) + " s and " + fixed(last.moved_m, 2) + " m; touched " +
                    (last.has_collided ? printable(last.with) : "nothing") + ".\n");
  return last.has_collided ? ExitCode::kOther : ExitCode::kDone;
}

ExitCode run(const Arguments& arguments) {
  const StopSignals signals;
  const Expected<ExitCode> lived = live(arguments, signals);
  if (lived) return *lived;
  complain(lived.error().message);
  return exitCodeOf(lived.error().code);
}

}  // namespace

Subcommand addSimCommand(CLI::App& program) {
  CLI::App& command =
      *program.add_subcommand("sim", "Stand in for a robot: simulated senses and gaits, over DDS");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addPose(command, "--start", arguments->start, "Where the robot is [m, m, rad]")->required();
  command.add_option("--start-mode", arguments->start_mode, "Mode it is in (the robot's first)")
      ->type_name("MODE");
  addTruth(command, arguments->truth);
  addRate(command, arguments->rate, "Simulated seconds in a second (1)");
  addWire(command, arguments->wire);
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
