#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <memory>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/inputs.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "bench/geometry.hpp"
#include "bench/refusals.hpp"
#include "bench/scenarios.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Benchmarks:\n"
    "  scenarios   the OBB paper's scenarios from nothing to a certified plan, 50 seeds each\n"
    "  refusals    proofs that no plan exists: how many of the true ones are found, and how many are false\n"
    "  geometry    the collision engine: exactness against a slow reference, speed against FCL\n"
    "Examples:\n"
    "  underway bench scenarios --json scenarios.json\n"
    "  underway bench geometry --quick\n"
    "  underway bench geometry --grid office.pgm --resolution-m 0.05";

struct Arguments {
  std::string name;
  std::string json;
  bench::GeometryOptions geometry;
};

/// As many digits as say something: "0.021", "31.5", "1482", "1.6e-06".
std::string brief(double number) {
  const double size = std::abs(number);
  if (size != 0.0 && (size < 1e-3 || size >= 1e7)) return fmt::format("{:.1e}", number);
  if (number == std::round(number)) return fixed(number, 0);
  return fixed(number, size < 10.0 ? 3 : size < 1000.0 ? 1 : 0);
}

std::string tableOf(const bench::Report& report) {
  using Align = Table::Align;
  Table table({{"what"},
               {"value", Align::kRight},
               {"unit"},
               {"against"},
               {"its value", Align::kRight},
               {"ratio", Align::kRight},
               {"asked"},
               {"met"}});
  for (const bench::Row& row : report.rows)
    table.add({{row.what},
               {brief(row.value)},
               {row.unit},
               {row.peer ? row.peer->name : ""},
               {row.peer ? brief(row.peer->value) : ""},
               {row.ratio ? brief(*row.ratio) : ""},
               {row.goal},
               {!row.met   ? ""
                : *row.met ? "yes"
                           : "no",
                row.met.value_or(true) ? "32" : "31"}});
  return table.text(wantsColour());
}

Expected<bench::Report> measure(const Arguments& arguments) {
  ProgressBar bar("measuring");
  const auto progress = [&](double share) { bar.show(share); };
  if (arguments.name == "geometry") return bench::geometry(arguments.geometry, progress);
  const auto data = findDataFolder();
  if (!data) return tl::unexpected(data.error());
  return arguments.name == "refusals" ? bench::refusals(*data, progress) : bench::scenarios(*data, progress);
}

ExitCode run(const Arguments& arguments) {
  const bool has_geometry_options =
      arguments.geometry.quick || !arguments.geometry.grid.empty() || arguments.geometry.resolution_m;
  if (arguments.name != "geometry" && has_geometry_options) {
    complain("--quick, --grid and --resolution-m are for `underway bench geometry`; leave them out");
    return ExitCode::kInvalidInput;
  }
  const auto report = measure(arguments);
  if (!report) {
    complain(report.error().message);
    return exitCodeOf(report.error().code);
  }
  return deliverFigures(tableOf(*report), bench::toJson(*report), arguments.json);
}

}  // namespace

Command addBenchCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("bench", "Measure the planner and its parts");
  const auto arguments = std::make_shared<Arguments>();
  command.add_option("name", arguments->name, "Which benchmark")
      ->required()
      ->check(CLI::IsMember({"scenarios", "refusals", "geometry"}));
  command.add_option("--json", arguments->json, "Write the figures; - for standard output")
      ->type_name("FILE|-");
  command.add_flag("--quick", arguments->geometry.quick, "geometry: a hundredth of the random cases");
  command.add_option("--grid", arguments->geometry.grid, "geometry: a large grid map (YAML, or an image)")
      ->type_name("FILE");
  command.add_option("--resolution-m", arguments->geometry.resolution_m, "geometry: cell size of an image")
      ->type_name("R");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
