#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/inputs.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "bench/gait.hpp"
#include "bench/geometry.hpp"
#include "bench/local.hpp"
#include "bench/peer_queries.hpp"
#include "bench/physics.hpp"
#include "bench/planner.hpp"
#include "bench/planners.hpp"
#include "bench/refusals.hpp"
#include "bench/requests.hpp"
#include "bench/scenarios.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Benchmarks:\n"
    "  scenarios   the OBB paper's scenarios from nothing to a certified plan, 50 seeds each\n"
    "  refusals    proofs that no plan exists: how many of the true ones are found, and how many are false\n"
    "  geometry    the collision engine: exactness against a slow reference, speed against FCL\n"
    "  planner     the planner: cold and warm, against the oracle, its deadlines, how it grows\n"
    "  local       GODZILA alone, and plans executed by a simulated robot\n"
    "  planners    our planner and OMPL's own on any map, robot and queries\n"
    "  gait        the crawl in its model: nominal and optimised, the library, how fast it is computed\n"
    "  physics     the crawl on a NAO in MuJoCo: advance, height, torques, going down and up, under a table\n"
    "  peers       queries on real buildings that other planners have answered\n"
    "Examples:\n"
    "  underway bench scenarios --json scenarios.json\n"
    "  underway bench geometry --quick\n"
    "  underway bench geometry --grid office.pgm --resolution-m 0.05\n"
    "  underway bench planner --maps2d ../shared/maps/maps2d --only cost\n"
    "  underway bench local --quick --only pure\n"
    "  underway bench local --only unmapped --map maps/flat.yaml --seed 3 --seeds 1\n"
    "  underway bench planners --map maps/scenario3.yaml --plots out/bench/planners\n"
    "  underway bench physics --only journeys --plots out/bench/physics\n"
    "  underway bench physics --only lines --quick\n"
    "  underway bench peers --peers ../shared/peers --maps2d ../shared/maps/maps2d";

struct Arguments {
  std::string name;
  std::string json;
  bool quick = false;
  std::string grid;
  MapArguments map;
  std::string robot = "nao";
  std::string queries;
  std::string plots;
  int runs = 20;
  double limit_s = 5.0;
  std::string peers;
  std::string maps2d;
  std::string only;
  double own_s = 0.0;
  std::uint64_t seed = 1;
  std::uint64_t seeds = 0;
};

/// Which options are for which benchmarks: what is given to another would be passed over in silence.
struct Belongs {
  const char* option;
  bool is_given;
  std::vector<std::string_view> benchmarks;
};

/// What a benchmark can measure alone.
std::vector<std::string> partsOf(std::string_view benchmark) {
  if (benchmark == "local") return bench::localParts();
  if (benchmark == "planner") return bench::plannerParts();
  return benchmark == "physics" ? bench::physicsParts() : std::vector<std::string>{};
}

/// A sentence about the first option that does not belong to the benchmark.
std::optional<std::string> misplaced(const Arguments& arguments) {
  const std::vector<Belongs> options{
      {"--quick", arguments.quick, {"geometry", "local", "peers", "physics", "planner", "planners"}},
      {"--grid", !arguments.grid.empty(), {"geometry"}},
      {"--resolution-m", arguments.map.options.resolution_m.has_value(), {"geometry", "planners"}},
      {"--map", !arguments.map.file.empty(), {"local", "planners"}},
      {"--queries", !arguments.queries.empty(), {"planners"}},
      {"--plots", !arguments.plots.empty(), {"physics", "planners"}},
      {"--peers", !arguments.peers.empty(), {"peers"}},
      {"--maps2d", !arguments.maps2d.empty(), {"peers", "planner"}},
      {"--only", !arguments.only.empty(), {"local", "physics", "planner"}},
      {"--own-s", arguments.own_s > 0.0, {"planner"}},
      {"--seed", arguments.seed != 1, {"local"}},
      {"--seeds", arguments.seeds > 0, {"local"}},
  };
  for (const Belongs& option : options)
    if (option.is_given && std::find(option.benchmarks.begin(), option.benchmarks.end(), arguments.name) ==
                               option.benchmarks.end())
      return fmt::format("{} is not for `underway bench {}`; leave it out", option.option, arguments.name);
  const std::vector<std::string> parts = partsOf(arguments.name);
  if (!arguments.only.empty() && std::ranges::find(parts, arguments.only) == parts.end())
    return fmt::format("`underway bench {}` has no part {}; name one of {}", arguments.name, arguments.only,
                       fmt::join(parts, ", "));
  if (arguments.name == "local" && !arguments.map.file.empty() && !bench::isOnMaps(arguments.only))
    return "--map is for --only plans, unmapped or blocked; name one of them";
  if (arguments.name == "peers" && arguments.peers.empty())
    return "`underway bench peers` needs --peers, the folder of their queries";
  if (arguments.name == "planners" && arguments.map.file.empty())
    return "`underway bench planners` needs --map";
  return std::nullopt;
}

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

/// The map's own queries that can be answered, or those of a file.
Expected<bench::PlannersOptions> planningOptions(const Arguments& arguments) {
  const auto site = readSite(arguments.map, arguments.robot);
  if (!site) return tl::unexpected(site.error());
  bench::PlannersOptions options{site->world,    site->robot,       {},
                                 arguments.runs, arguments.limit_s, arguments.plots};
  if (!arguments.queries.empty()) {
    auto queries = bench::readQueries(arguments.queries);
    if (!queries) return tl::unexpected(queries.error());
    options.queries = std::move(*queries);
  } else {
    for (const Query& query : site->queries)
      if (query.expect == "ok")
        options.queries.emplace_back(query.name, bench::requestOf(query, *site->robot));
  }
  if (arguments.quick) {
    options.runs = std::min(options.runs, 3);
    options.queries.resize(std::min<std::size_t>(options.queries.size(), 3));
  }
  return options;
}

Expected<bench::Report> measure(const Arguments& arguments) {
  ProgressBar bar("measuring");
  const auto progress = [&](double share) { bar.show(share); };
  if (arguments.name == "geometry")
    return bench::geometry({arguments.quick, arguments.grid, arguments.map.options.resolution_m}, progress);
  if (arguments.name == "peers")
    return bench::peerQueries({arguments.peers, arguments.maps2d, arguments.quick}, progress);
  if (arguments.name == "planners") {
    const auto options = planningOptions(arguments);
    if (!options) return tl::unexpected(options.error());
    return bench::planners(*options, progress);
  }
  const auto data = findDataFolder();
  if (!data) return tl::unexpected(data.error());
  if (arguments.name == "gait") return bench::gait(*data, progress);
  if (arguments.name == "physics")
    return bench::physics({*data, arguments.quick, arguments.plots, arguments.only}, progress);
  if (arguments.name == "local")
    return bench::local(
        {*data, arguments.quick, arguments.only, arguments.map.file, arguments.seed, arguments.seeds},
        progress, [&](const std::string& amiss) { bar.say(amiss); });
  if (arguments.name == "planner")
    return bench::planner({*data, arguments.maps2d, arguments.quick, arguments.own_s, arguments.only},
                          progress);
  return arguments.name == "refusals" ? bench::refusals(*data, progress) : bench::scenarios(*data, progress);
}

ExitCode run(const Arguments& arguments) {
  if (const auto sentence = misplaced(arguments)) {
    complain(*sentence);
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

Subcommand addBenchCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("bench", "Measure the planner and its parts");
  const auto arguments = std::make_shared<Arguments>();
  command.add_option("name", arguments->name, "Which benchmark")
      ->required()
      ->check(CLI::IsMember(
          {"scenarios", "refusals", "gait", "geometry", "local", "peers", "physics", "planner", "planners"}));
  addOutputFile(command, "--json", arguments->json, "FILE|-", "Write the figures; - for standard output");
  command.add_flag("--quick", arguments->quick, "A small share of the cases");
  command.add_option("--grid", arguments->grid, "geometry: a large grid map (YAML, or an image)")
      ->type_name("FILE");
  addMap(command, arguments->map);
  addRobot(command, arguments->robot);
  command.add_option("--queries", arguments->queries, "planners: starts and goals (CSV); else the map's own")
      ->type_name("FILE");
  addWhole(command, "--runs", arguments->runs, 1, 100'000, "planners: of each on each query (20)");
  addNumber(command, "--limit-s", arguments->limit_s, 0.001, 3600.0, "S", "planners: of each run (5)");
  command
      .add_option("--plots", arguments->plots,
                  "planners: write OMPL's log, a table and pictures here; physics: pictures of its journeys")
      ->type_name("DIR");
  command.add_option("--peers", arguments->peers, "peers: folder of their queries (CSV)")->type_name("DIR");
  command.add_option("--maps2d", arguments->maps2d, "peers, planner: folder of large grid maps")
      ->type_name("DIR");
  command.add_option("--only", arguments->only, "local, physics, planner: one part of it")
      ->check(CLI::IsMember(partsOf("local")) | CLI::IsMember(partsOf("planner")) |
              CLI::IsMember(partsOf("physics")));
  addNumber(command, "--own-s", arguments->own_s, 0.0, 86400.0, "S",
            "planner: help the oracle with the planner's own best after S seconds (0: not)");
  addWhole(command, "--seed", arguments->seed, 0, 1'000'000'000, "local: the first seed (1)");
  addWhole(command, "--seeds", arguments->seeds, 1, 1'000'000,
           "local: how many; else as many as is asked for");
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
