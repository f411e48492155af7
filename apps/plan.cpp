#include <memory>

#include "apps/commands.hpp"
#include "apps/deliver.hpp"
#include "apps/draw_svg.hpp"
#include "apps/inputs.hpp"
#include "apps/roadmap_store.hpp"
#include "apps/terminal.hpp"
#include "planner/planner.hpp"
#include "server/served.hpp"

namespace underway {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  underway plan --map maps/scenario3.yaml --query under_the_table --svg plan.svg\n"
    "  underway plan --map maps/scenario3.yaml --start 0.6,2,0 --goal 5.4,2 --policy fastest --json -\n"
    "  underway plan --map floor.pgm --resolution-m 0.05 --origin 0,0,0 --occupied-thresh 0.65 \\\n"
    "                --free-thresh 0.196 --unknown free --robot nao_obb_paper --start 1,1,0 --goal 4,3,1.57\n"
    "  underway plan --map maps/flat.yaml --query under_the_bed --roadmap flat.roadmap\n"
    "  underway plan --map maps/scenario3.yaml --start 0.6,2,0 --goal 5.4,2 --goal 5.4,0.8,1.57\n"
    "  underway plan --map changed.yaml --replan plan.json --segment 3 --done 0.4\n"
    "Exit codes: 0 a plan, 3 a valid 'no', 2 invalid input, 1 anything else.";

struct Arguments {
  MapArguments map;
  std::string robot;
  QueryArguments query;
  FollowArguments follow;
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

/// Plans, or plans anew if a plan is being followed.
Expected<Plan> planBy(Planner& planner, const Asked& asked, Planner::Clock::time_point deadline,
                      std::optional<Choice>& choice) {
  ProgressBar bar("growing the roadmap");
  if (asked.purpose == Purpose::kPlan)
    return planner.plan(asked.request, deadline, {}, [&](double share) { bar.show(share); });
  auto given = replan(planner, asked.executing, asked.request, deadline, asked.reluctance);
  if (!given) return tl::unexpected(given.error());
  choice = Choice{given->is_new, std::move(given->why)};
  return std::move(given->plan);
}

Expected<Plan> planAt(const Site& site, const Asked& asked, const Arguments& arguments,
                      std::shared_ptr<const Roadmap>& roadmap, std::optional<Choice>& choice) {
  const auto start = Planner::Clock::now();
  Planner planner(site.world, site.robot, arguments.growth);
  RoadmapStore store(arguments.roadmap_file);
  store.loadInto(planner);
  Expected<Plan> plan = planBy(planner, asked, start + arguments.query.deadline, choice);
  store.saveFrom(planner);
  roadmap = planner.roadmap();
  return plan;
}

/// What is asked, in the robot's modes.
Expected<Asked> askedOf(const Arguments& arguments, const Site& site) {
  if (!arguments.follow.isGiven()) {
    Expected<QueryArguments> query = arguments.query;
    if (!arguments.query_name.empty())
      query = queryNamed(arguments.query_name, site.queries, arguments.query);
    if (!query) return tl::unexpected(query.error());
    return requestOf(*query, *site.robot).map([](const Request& request) { return Asked{request}; });
  }
  Expected<FollowedPlan> followed = readFollowed(arguments.follow, *site.robot);
  if (!followed) return tl::unexpected(followed.error());
  Asked asked{requestOf(*followed, arguments.query, *site.robot), Purpose::kReplan};
  asked.executing = std::move(followed->executing);
  asked.reluctance.share = arguments.follow.gain;
  return asked;
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

  const Expected<Asked> asked = askedOf(arguments, *site);
  if (!asked) return refuse(asked.error());
  setRequest(asked->request, *site->robot, document);

  document.answer = planAt(*site, *asked, arguments, answered.roadmap, document.choice);
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

Subcommand addPlanCommand(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("plan", "Plan a way on the spot");
  const auto arguments = std::make_shared<Arguments>();
  addMap(command, arguments->map)->required();
  addRobot(command, arguments->robot);
  addQuery(command, arguments->query);
  command.add_option("--query", arguments->query_name, "Take start and goal from this query of the scenario")
      ->type_name("NAME")
      ->excludes("--start", "--start-mode", "--goal", "--goal-mode");
  addReplan(command, arguments->follow);
  command.get_option("--replan")->excludes("--query");
  addOutput(command, arguments->output);
  addSeed(command, arguments->growth.seed);
  addRoadmap(command, arguments->roadmap_file);
  command.footer(kExamples);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace underway
