#include "bench/planner.hpp"

#include <array>

#include "bench/planner_parts.hpp"

namespace underway::bench {
namespace {

struct Part {
  const char* name;
  Expected<void> (*add)(const PlannerOptions&, Report&, const Progress&);
};
constexpr std::array kParts{Part{"cold", addCold},       Part{"warm", addWarm},
                            Part{"cost", addCost},       Part{"deadlines", addDeadlines},
                            Part{"change", addChange},   Part{"narrow", addNarrow},
                            Part{"scaling", addScaling}, Part{"buildings", addBuildings}};

}  // namespace

std::vector<std::string> plannerParts() {
  std::vector<std::string> names;
  for (const Part& part : kParts) names.emplace_back(part.name);
  return names;
}

Expected<Report> planner(const PlannerOptions& options, const Progress& progress) {
  Report report{"planner", {}};
  bool is_known = options.only.empty();
  for (const Part& part : kParts) {
    if (!options.only.empty() && options.only != part.name) continue;
    is_known = true;
    if (const auto added = part.add(options, report, progress); !added) return tl::unexpected(added.error());
  }
  if (!is_known)
    return fail(ErrorCode::kInvalidRequest, "the planner's benchmark has no part '" + options.only + "'");
  return report;
}

Expected<std::shared_ptr<const Robot>> naoOf(const PlannerOptions& options) {
  auto robot = readRobot(options.data / "robots" / "nao.yaml");
  if (!robot) return tl::unexpected(robot.error());
  return std::make_shared<const Robot>(std::move(*robot));
}

Expected<std::shared_ptr<const World>> worldOf(const std::filesystem::path& file) {
  auto map = readMap(file);
  if (!map) return tl::unexpected(map.error());
  return std::make_shared<const World>(std::move(map->world));
}

std::unique_ptr<Planner> preparedPlanner(const std::shared_ptr<const World>& world,
                                         const std::shared_ptr<const Robot>& robot, GrowthSettings settings) {
  auto planner = std::make_unique<Planner>(world, robot, settings);
  planner->prepare(Planner::Clock::now() + std::chrono::minutes(1));
  return planner;
}

}  // namespace underway::bench
