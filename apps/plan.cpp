#include <memory>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/draw_svg.hpp"
#include "apps/inputs.hpp"
#include "apps/roadmap_store.hpp"
#include "apps/terminal.hpp"
#include "planner/planner.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway plan --map maps/scenario3.yaml --query under_the_table --svg plan.svg\n"
    "  underway plan --map maps/scenario3.yaml --start 0.6,2,0 --goal 5.4,2 --policy fastest --json -\n"
    "  underway plan --map floor.pgm --resolution-m 0.05 --origin 0,0,0 --occupied-thresh 0.65 \\\n"
    "                --free-thresh 0.196 --unknown free --robot nao_obb_paper --start 1,1,0 --goal 4,3,1.57\n"
    "  underway plan --map maps/flat.yaml --query under_the_bed --roadmap flat.roadmap\n"
    "Exit codes: 0 a plan, 3 a valid 'no', 2 invalid input, 1 anything else.";

struct Arguments {
  MapArguments map;
  std::string robot;
  QueryArguments query;
  std::string query_name;
  OutputArguments output;
  GrowthSettings growth;
  std::string roadmap_file;
};

/// An answer and what it was made with; empty where it did not come so far.
struct Answered {
  PlanDocument document;
  Site site;
  std::shared_ptr<const Roadmap> roadmap;
};

Expected<Plan> planAt(const Site& site, const Request& request, const Arguments& arguments,
                      std::shared_ptr<const Roadmap>& roadmap) {
  const auto start = Planner::Clock::now();
  Planner planner(site.world, site.robot, arguments.growth);
  RoadmapStore store(arguments.roadmap_file);
  store.loadInto(planner);
  ProgressBar bar("growing the roadmap");
  Expected<Plan> plan =
      planner.plan(request, start + arguments.query.deadline, {}, [&](double share) { bar.show(share); });
  store.saveFrom(planner);
  roadmap = planner.roadmap();
  return plan;
}

Answered answer(const Arguments& arguments) {
  Answered answered{documentOf(arguments.query), {}, nullptr};
  PlanDocument& document = answered.document;
  const auto refuse = [&](const Error& error) {
    document.answer = tl::unexpected(error);
    return answered;
  };
  Expected<Site> site = readSite(arguments.map, arguments.robot);
  if (!site) return refuse(site.error());
  answered.site = *site;
  describeSite(*site, arguments.growth.seed, document);

  Expected<QueryArguments> query = arguments.query;
  if (!arguments.query_name.empty()) query = queryNamed(arguments.query_name, site->queries, arguments.query);
  if (!query) return refuse(query.error());
  const Expected<Request> request = requestOf(*query, *site->robot);
  if (!request) return refuse(request.error());
  setRequest(*request, *site->robot, document);

  document.answer = planAt(*site, *request, arguments, answered.roadmap);
  return answered;
}

ExitCode run(const Arguments& arguments) {
  const Answered answered = answer(arguments);
  const Site& site = answered.site;
  if (!site.world) return deliver(answered.document, arguments.output, {});
  return deliver(answered.document, arguments.output, [&] {
    return drawSvg({*site.world, *site.robot, answered.roadmap.get(), &answered.document});
  });
}

}  // namespace

Command addPlanCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("plan", "Plan a way on the spot");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addQuery(command, arguments->query);
  command.add_option("--query", arguments->query_name, "Take start and goal from this query of the scenario")
      ->type_name("NAME")
      ->excludes("--start", "--start-mode", "--goal", "--goal-mode");
  addOutput(command, arguments->output);
  addSeed(command, arguments->growth.seed);
  addRoadmap(command, arguments->roadmap_file);
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
