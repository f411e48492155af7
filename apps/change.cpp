#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/rivals.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "server/change_client.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway change --add box=3,2,0.2,0.4,0.4,0.4\n"
    "  underway change --move table_top=4,2.2,0.65,0.4,0.8,0.7 --remove box --if-revision 2\n"
    "  underway change --remove-all nao.           # what robot nao saw\n"
    "  underway change                            # changes nothing, tells how the world is\n"
    "All changes are made or none: first what is removed, then what is moved, then what is added.\n"
    "Exit codes: 0 done, 3 another revision than --if-revision, 2 invalid input, 4 no server, 1 anything "
    "else.";

struct Arguments {
  std::string robot_name = "operator";
  DomainSettings domain;
  std::vector<std::string> removed;
  std::vector<std::string> removed_all;
  std::vector<Obstacle> moved;
  std::vector<Obstacle> added;
  std::uint64_t if_revision = 0;
  std::string json;
};

ChangeQuestion questionOf(const Arguments& arguments) {
  ChangeQuestion question{arguments.robot_name, {}, arguments.if_revision};
  for (const std::string& id : arguments.removed)
    question.changes.push_back({WorldChange::Kind::kRemove, id});
  for (const std::string& beginning : arguments.removed_all)
    question.changes.push_back({WorldChange::Kind::kRemoveAll, beginning});
  for (const Obstacle& obstacle : arguments.moved)
    question.changes.push_back({WorldChange::Kind::kMove, obstacle.id, obstacle.box});
  for (const Obstacle& obstacle : arguments.added)
    question.changes.push_back({WorldChange::Kind::kAdd, obstacle.id, obstacle.box});
  return question;
}

Expected<ChangeAnswer> askServer(const Arguments& arguments) {
  const auto domain = Domain::open(arguments.domain);
  if (!domain) return tl::unexpected(domain.error());
  Expected<ChangeClient> client = ChangeClient::open(*domain);
  if (!client) return tl::unexpected(client.error());
  Expected<ChangeAnswer> answer = client->ask(questionOf(arguments));
  if (answer) complainOfRivals(client->servers(), arguments.domain.id);
  return answer;
}

std::string tableOf(const ChangeAnswer& answer) {
  const WorldNow& world = answer.world;
  std::string text = "Map " + printable(world.map_name) + ": revision " + std::to_string(world.revision) +
                     ", " + std::to_string(world.obstacles) + " obstacles, hash " + printable(world.hash) +
                     ".\n";
  if (!answer.repaired || answer.repaired->checked == 0) return text;
  return text + "Roadmap: " + std::to_string(answer.repaired->checked) + " links looked at again, " +
         std::to_string(answer.repaired->closed) + " ways closed, " +
         std::to_string(answer.repaired->opened) + " opened, in " + fixed(answer.took_ms, 2) + " ms.\n";
}

std::string jsonOf(const ChangeAnswer& answer) {
  using Json = nlohmann::ordered_json;
  const Repair repair = answer.repaired.value_or(Repair{});
  const Json json{{"status", answer.repaired ? std::string_view("ok") : name(answer.repaired.error().code)},
                  {"message", answer.repaired ? std::string() : answer.repaired.error().message},
                  {"map", answer.world.map_name},
                  {"revision", answer.world.revision},
                  {"world_hash", answer.world.hash},
                  {"obstacles", answer.world.obstacles},
                  {"links_checked", repair.checked},
                  {"ways_closed", repair.closed},
                  {"ways_opened", repair.opened},
                  {"took_ms", answer.took_ms}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

ExitCode run(const Arguments& arguments) {
  const Expected<ChangeAnswer> answer = askServer(arguments);
  if (!answer) {
    complain(answer.error().message);
    return exitCodeOf(answer.error().code);
  }
  const ExitCode delivered = deliverFigures(tableOf(*answer), jsonOf(*answer), arguments.json);
  if (answer->repaired || delivered != ExitCode::kDone) return delivered;
  complain(printable(answer->repaired.error().message));
  return exitCodeOf(answer->repaired.error().code);
}

}  // namespace

Subcommand addChangeCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("change", "Change the world of a server, over DDS");
  const auto arguments = std::make_shared<Arguments>();
  addObstacles(command, "--add", arguments->added, "A new obstacle: middle and full size of a box [m, rad]");
  addObstacles(command, "--move", arguments->moved, "An obstacle and the box it becomes [m, rad]");
  command.add_option("--remove", arguments->removed, "An obstacle that goes")
      ->type_name("ID")
      ->allow_extra_args(false);
  command
      .add_option("--remove-all", arguments->removed_all,
                  "All obstacles whose ids begin so go; there may be none. NAME. is what robot NAME saw")
      ->type_name("BEGINNING")
      ->allow_extra_args(false);
  addWhole(command, "--if-revision", arguments->if_revision, "Only if the world is at this revision");
  command.add_option("--robot-name", arguments->robot_name, "Who asks (operator)")->type_name("NAME");
  addDomain(command, arguments->domain);
  addOutputFile(command, "--json", arguments->json, "FILE|-", "Write the answer; - for standard output");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
