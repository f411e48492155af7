#include <memory>

#include "apps/commands.hpp"
#include "apps/inputs.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "planner/certify.hpp"
#include "planner/plan_document.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway check plan.json --map maps/scenario3.yaml\n"
    "  underway check plan.json --map changed.yaml --stale --segment 3 --done 0.4\n"
    "Exit codes: 0 sound, or it may still be followed, 3 flawed or stale, 2 invalid input.";

struct Arguments {
  FollowArguments plan;
  bool only_stale = false;
  MapArguments map;
  std::string robot;
};

/// That the plan is of another map altogether; empty if it is not.
std::string otherMapOf(const PlanDocument& document, const Site& site) {
  if (document.map_name == site.world->name()) return {};
  return "The plan is of map " + printable(document.map_name) + ", not of " + printable(site.world->name()) +
         ".\n";
}

/// What the plan was made for, where that is not what it is checked against; empty if it is.
std::string stalenessOf(const PlanDocument& document, const Site& site) {
  if (std::string other = otherMapOf(document, site); !other.empty()) return other;
  std::string what;
  if (document.world_hash != site.world->hash()) what = "map";
  if (document.robot_hash != hashOf(*site.robot)) what += what.empty() ? "robot" : " and robot";
  if (what.empty()) return {};
  return "The plan is stale: it was made for another version of the " + what + ".\n";
}

std::string listOf(const std::vector<Flaw>& flaws, std::size_t segments) {
  if (flaws.empty()) return "Sound: " + std::to_string(segments) + " segments certified.\n";
  std::string text;
  for (const Flaw& flaw : flaws) {
    const bool is_whole = flaw.segment >= segments;
    text += (is_whole ? "plan: " : "segment " + std::to_string(flaw.segment + 1) + ": ") +
            printable(flaw.sentence) + "\n";
  }
  return text + "Flawed: " + std::to_string(flaws.size()) + (flaws.size() == 1 ? " flaw.\n" : " flaws.\n");
}

struct Verdict {
  std::string text;
  bool is_sound = false;
};

Verdict certified(const FollowedPlan& plan, const Site& site) {
  const Plan& made = *plan.document.answer;
  const std::vector<Flaw> flaws = certify(made, plan.document.request, Checker(site.world, site.robot));
  return {stalenessOf(plan.document, site) + listOf(flaws, made.segments.size()), flaws.empty()};
}

/// Whether what is left of the plan may be followed in the map as it is, whatever it was made in.
Expected<Verdict> staleness(const FollowedPlan& plan, const Site& site) {
  const std::string other = otherMapOf(plan.document, site);
  const auto left = remaining(plan.executing, Checker(site.world, site.robot));
  if (left)
    return Verdict{other + "It may be followed: " + std::to_string(left->segments.size()) +
                       " segments are left, " + fixed(left->total_time_s, 1) + " s.\n",
                   true};
  if (left.error().code != ErrorCode::kStaleRevision) return tl::unexpected(left.error());
  return Verdict{other + "Stale: " + printable(left.error().message) + ".\n", false};
}

Expected<Verdict> judge(const Arguments& arguments) {
  const Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  const Expected<FollowedPlan> plan = readFollowed(arguments.plan, *site->robot);
  if (!plan) return tl::unexpected(plan.error());
  if (arguments.only_stale) return staleness(*plan, *site);
  return certified(*plan, *site);
}

ExitCode run(const Arguments& arguments) {
  const Expected<Verdict> verdict = judge(arguments);
  if (!verdict) {
    complain(verdict.error().message);
    return exitCodeOf(verdict.error().code);
  }
  if (const Expected<void> written = writeOutput(verdict->text); !written) {
    complain(written.error().message);
    return ExitCode::kOther;
  }
  return verdict->is_sound ? ExitCode::kDone : ExitCode::kNo;
}

}  // namespace

Subcommand addCheckCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("check", "Judge a plan file by the certificate alone");
  const auto arguments = std::make_shared<Arguments>();
  command.add_option("PLAN", arguments->plan.stale, "A file written by --json")
      ->required()
      ->type_name("FILE");
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  command.add_flag("--stale", arguments->only_stale,
                   "Only tell whether it may be followed in this map, from where the robot is on it");
  addProgress(command, arguments->plan);
  command.get_option("--segment")->needs("--stale");
  command.get_option("--done")->needs("--stale");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
