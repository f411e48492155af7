#include "apps/optimise.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <map>
#include <memory>

#include "apps/arguments.hpp"
#include "apps/chart.hpp"
#include "apps/table.hpp"
#include "apps/terminal.hpp"
#include "apps/text_file.hpp"
#include "gait/crawl/recipes.hpp"
#include "gait/nao.hpp"

namespace underway {
namespace {

using namespace gait;

const std::map<std::string, Aim> kAims{{"torque", Aim::kTorque},
                                       {"even", Aim::kEvenTorque},
                                       {"speed", Aim::kSpeed},
                                       {"level", Aim::kLevelBack},
                                       {"steady", Aim::kSteadyHead}};

const std::map<std::string, InternalForce::Kind> kForces{{"none", InternalForce::Kind::kNone},
                                                         {"servo", InternalForce::Kind::kServo}};

constexpr const char* kExamples =
    "Examples:\n"
    "  underway gait optimise --aim torque --out mine.json\n"
    "  underway gait optimise --aim torque --method genetic --seed 3 --plot search.svg --out mine.json\n"
    "  underway gait optimise --aim level --free-ends --height-m 0.1 --push-s 2 --out mine.json\n"
    "  underway gait crawl --gait mine.json --out crawl.csv";

struct Arguments {
  std::string aim = "torque";
  std::string force = "servo";
  std::string method = "descent";
  std::uint64_t seed = 1;
  int evaluations = 7200;
  bool has_free_ends = false;
  double height_m = PushLimits{}.height_most_m;
  double push_s = CrawlTimes{}.push_s;
  std::string out;
  std::string plot;
};

struct Problem {
  CrawlGait from = nominalGait();
  PushSetting setting;
  ChainMasses masses = chainMassesOf(nao());
};

Problem problemOf(const Arguments& arguments) {
  Problem problem;
  problem.from.times.push_s = arguments.push_s;
  problem.setting.toe_to_elbow_m = problem.from.toe_to_elbow_m;
  problem.setting.spread_m = problem.from.spread_m;
  problem.setting.push_s = arguments.push_s;
  problem.setting.limits.height_most_m = arguments.height_m;
  problem.setting.force.kind = kForces.at(arguments.force);
  return problem;
}

Found search(const Arguments& arguments, const Problem& problem, const SearchSpace& space) {
  const Objective objective =
      objectiveFor(naoCrawler(), problem.masses, space, problem.setting, kAims.at(arguments.aim));
  ProgressBar bar("optimising");
  const SearchProgress progress = [&](double share, double) { bar.show(share); };
  if (arguments.method == "descent")
    return searchDescent(objective, space, {arguments.evaluations, arguments.seed}, progress);
  GeneticSettings settings;
  settings.seed = arguments.seed;
  settings.generations = std::max(1, arguments.evaluations / settings.population);
  return searchGenetic(objective, space, settings, progress);
}

std::string tableOf(const PushFigures& nominal, const PushFigures& found, int evaluations) {
  using Align = Table::Align;
  Table table({{"push"}, {"nominal", Align::kRight}, {"found", Align::kRight}, {"unit"}});
  const auto add = [&](const char* what, double of_nominal, double of_found, const char* unit) {
    table.add({{what}, {fixed(of_nominal, 3)}, {fixed(of_found, 3)}, {unit}});
  };
  add("torque, paper's weights", torqueCost(nominal, kPaperWeights), torqueCost(found, kPaperWeights),
      "N2m2");
  add("torque, evenly", torqueCost(nominal, kEvenWeights), torqueCost(found, kEvenWeights), "N2m2");
  add("largest torque", nominal.peak_nm, found.peak_nm, "Nm");
  add("highest joint", 1e3 * nominal.highest_m, 1e3 * found.highest_m, "mm");
  add("lowest hip", 1e3 * nominal.hip_lowest_m, 1e3 * found.hip_lowest_m, "mm");
  add("back's slope", degrees(std::sqrt(nominal.back_rad2)), degrees(std::sqrt(found.back_rad2)), "deg");
  add("head off an even way", 1e3 * std::sqrt(nominal.head_m2), 1e3 * std::sqrt(found.head_m2), "mm");
  add("shortest time", nominal.shortest_s, found.shortest_s, "s");
  return table.text(wantsColour()) + fmt::format("{} evaluations\n", evaluations);
}

/// The thesis' figure 66: best and mean as the search goes on. What violates a limit is cut off.
std::string drawSearch(const Found& found) {
  Chart chart{"Cost as the search goes on", "generation, or hundred evaluations", "cost", {}, false};
  Series best{"best so far", "#2f9e44", false, {}};
  Series mean{"mean", "#868e96", true, {}};
  for (std::size_t i = 0; i < found.history.size(); ++i) {
    const double at = static_cast<double>(i);
    best.points.push_back({at, found.history[i].best});
    if (found.history[i].mean < 5.0 * found.cost) mean.points.push_back({at, found.history[i].mean});
  }
  chart.series = {mean, best};
  return drawCharts({chart}, "Optimisation of a push");
}

ExitCode refuse(const std::string& sentence, ExitCode code) {
  complain(sentence);
  return code;
}

ExitCode run(const Arguments& arguments) {
  constexpr double kKept = 1e-6;  ///< what rounding may leave of a violation
  const Problem problem = problemOf(arguments);
  const SearchSpace space(problem.from.push,
                          arguments.has_free_ends ? SearchSpace::Ends::kFree : SearchSpace::Ends::kFixed,
                          problem.setting.limits);
  const Found found = search(arguments, problem, space);
  GaitFile file{problem.from, "Optimised: " + arguments.aim, arguments.push_s, arguments.push_s};
  file.gait.name = "mine";
  file.gait.push = space.shapeAt(found.point);
  const auto figures = [&](const PushShape& push) {
    return evaluate(naoCrawler(), problem.masses, push, problem.setting);
  };
  const PushFigures best = figures(file.gait.push);
  if (best.violation > kKept)
    return refuse("no push was found that keeps all limits; allow more height, more time or free ends",
                  ExitCode::kNo);
  for (const auto& [name, text] :
       {std::pair{arguments.out, toJson(file)}, {arguments.plot, drawSearch(found)}})
    if (const auto written = name.empty() ? Expected<void>{} : writeText(name, text); !written)
      return refuse(written.error().message, ExitCode::kOther);
  const auto told = writeOutput(tableOf(figures(nominalPush()), best, found.evaluations));
  return told ? ExitCode::kDone : refuse(told.error().message, ExitCode::kOther);
}

std::vector<std::string> namesOf(const auto& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

}  // namespace

std::function<ExitCode()> addOptimise(CLI::App& gait_command, CLI::App*& command) {
  const auto arguments = std::make_shared<Arguments>();
  command = gait_command.add_subcommand("optimise", "Search a push of one's own, from the nominal one");
  command->add_option("--aim", arguments->aim, "What is to be small")
      ->check(CLI::IsMember(namesOf(kAims)))
      ->capture_default_str();
  command->add_option("--internal-force", arguments->force, "What toes and elbows press against each other")
      ->check(CLI::IsMember(namesOf(kForces)))
      ->capture_default_str();
  command->add_option("--method", arguments->method, "NLopt's, or the thesis' genetic algorithm")
      ->check(CLI::IsMember({"descent", "genetic"}))
      ->capture_default_str();
  addWhole(*command, "--seed", arguments->seed, "Of the random numbers (1)");
  addWhole(*command, "--evaluations", arguments->evaluations, 200, 10'000'000, "At most (7200)");
  command->add_flag("--free-ends", arguments->has_free_ends, "Knees and hips may begin and end elsewhere");
  addNumber(*command, "--height-m", arguments->height_m, 0.05, 1.0, "M",
            "No joint of the chain above this (" + fixed(arguments->height_m, 2) + ")");
  addNumber(*command, "--push-s", arguments->push_s, 0.1, 60.0, "S",
            "Duration of the push (" + fixed(arguments->push_s, 1) + ")");
  addOutputFile(*command, "--out", arguments->out, "FILE.json", "Write the gait");
  addOutputFile(*command, "--plot", arguments->plot, "FILE.svg", "Draw the search");
  command->footer(kExamples);
  return [arguments] { return run(*arguments); };
}

}  // namespace underway
