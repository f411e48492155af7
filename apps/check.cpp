#include <memory>

#include "apps/commands.hpp"
#include "apps/inputs.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "planner/certify.hpp"
#include "planner/plan_document.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway check plan.json --map maps/scenario3.yaml\n"
    "Exit codes: 0 sound, 3 flawed, 2 invalid input.";

struct Arguments {
  std::string plan;
  MapArguments map;
  std::string robot;
};

/// What the plan was made for, where that is not what it is checked against; empty if it is.
std::string stalenessOf(const PlanDocument& document, const Site& site) {
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

Expected<Verdict> judge(const Arguments& arguments) {
  const Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  const Expected<std::string> text = readText(arguments.plan);
  if (!text) return tl::unexpected(text.error());
  const Expected<PlanDocument> document = planFromJson(*text, *site->robot);
  if (!document) return tl::unexpected(document.error());
  if (!document->answer)
    return fail(ErrorCode::kInvalidRequest, "\"" + arguments.plan + "\" holds no plan but a failure (" +
                                                std::string(name(document->answer.error().code)) +
                                                "); there is nothing to check");
  const std::vector<Flaw> flaws =
      certify(*document->answer, document->request, Checker(site->world, site->robot));
  return Verdict{stalenessOf(*document, *site) + listOf(flaws, document->answer->segments.size()),
                 flaws.empty()};
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

Command addCheckCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("check", "Judge a plan file by the certificate alone");
  const auto arguments = std::make_shared<Arguments>();
  command.add_option("PLAN", arguments->plan, "A file written by --json")->required()->type_name("FILE");
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
