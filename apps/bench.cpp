#include <memory>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/inputs.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "bench/scenarios.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Benchmarks:\n"
    "  scenarios   the OBB paper's scenarios from nothing to a certified plan, 50 seeds each\n"
    "Examples:\n"
    "  underway bench scenarios\n"
    "  underway bench scenarios --json scenarios.json";

struct Arguments {
  std::string name;
  std::string json;
};

std::string tableOf(const bench::Report& report) {
  Table table({{"what"}, {"value", Table::Align::kRight}, {"unit"}, {"asked"}, {"met"}});
  for (const bench::Row& row : report.rows)
    table.add({{row.what},
               {fixed(row.value, row.unit.empty() ? 3 : 1)},
               {row.unit},
               {row.goal},
               {!row.met   ? ""
                : *row.met ? "yes"
                           : "no",
                row.met.value_or(true) ? "32" : "31"}});
  return table.text(wantsColour());
}

ExitCode run(const Arguments& arguments) {
  const auto data = findDataFolder();
  if (!data) {
    complain(data.error().message);
    return ExitCode::kInvalidInput;
  }
  ProgressBar bar("measuring");
  const auto report = bench::scenarios(*data, [&](double share) { bar.show(share); });
  if (!report) {
    complain(report.error().message);
    return ExitCode::kOther;
  }
  return deliverFigures(tableOf(*report), bench::toJson(*report), arguments.json);
}

}  // namespace

Command addBenchCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("bench", "Measure the planner on the maps that come along");
  const auto arguments = std::make_shared<Arguments>();
  command.add_option("name", arguments->name, "Which benchmark")
      ->required()
      ->check(CLI::IsMember({"scenarios"}));
  command.add_option("--json", arguments->json, "Write the figures; - for standard output")
      ->type_name("FILE|-");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
