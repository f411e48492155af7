#include <array>
#include <cmath>

#include "bench/planner_parts.hpp"

namespace underway::bench {
namespace {

constexpr double kTile_m = 8.0;        // one office: two rooms, a corridor, desks
constexpr std::array kTiles{1, 2, 4};  // to a side
constexpr double kWallHeight_m = 2.0;

Obstacle block(std::string id, double x, double y, Range z, double width_m, double depth_m) {
  return {std::move(id), OrientedBox{{x, y, 0.5 * (z.min + z.max)}, {width_m, depth_m, z.length()}, {}}};
}

/// One office with its lower left corner at (x, y). Its doors are in line with its neighbours'.
void addOffice(double x, double y, const std::string& name, std::vector<Obstacle>& blocks) {
  const Range wall{0.0, kWallHeight_m};
  const auto add = [&](const char* part, double at_x, double at_y, Range z, double width_m, double depth_m) {
    blocks.push_back(block(name + part, x + at_x, y + at_y, z, width_m, depth_m));
  };
  add("west_low", 0.05, 1.5, wall, 0.1, 3.0);  // a door from 3 to 4.2, on the corridor
  add("west_high", 0.05, 6.1, wall, 0.1, 3.8);
  add("south_left", 1.5, 0.05, wall, 2.8, 0.1);  // a door from 3 to 4
  add("south_right", 6.0, 0.05, wall, 4.0, 0.1);
  add("front_left", 1.2, 4.2, wall, 2.2, 0.1);  // doors from 2.3 to 3.2 and 4.4 to 5.4
  add("front_middle", 3.8, 4.2, wall, 1.2, 0.1);
  add("front_right", 6.7, 4.2, wall, 2.6, 0.1);
  add("between", 3.8, 6.2, wall, 0.1, 3.6);
  add("desk", 1.5, 6.5, {0.68, 0.72}, 1.6, 0.8);
  for (const double leg_x : {0.75, 2.25})
    for (const double leg_y : {6.15, 6.85})
      blocks.push_back(block(name + "leg" + std::to_string(leg_x) + std::to_string(leg_y), x + leg_x,
                             y + leg_y, {0.0, 0.68}, 0.06, 0.06));
  add("shelf", 6.0, 7.0, {0.3, 1.2}, 2.4, 0.4);
  add("cupboard", 7.0, 1.5, wall, 0.6, 1.0);
}

Expected<World> offices(int tiles) {
  std::vector<Obstacle> blocks;
  for (int row = 0; row < tiles; ++row)
    for (int column = 0; column < tiles; ++column)
      addOffice(column * kTile_m, row * kTile_m, std::to_string(row) + "_" + std::to_string(column) + "_",
                blocks);
  return World::make("offices", {{0.0, 0.0, 0.0}, tiles * kTile_m, tiles * kTile_m}, 0.0, std::move(blocks));
}

}  // namespace

Expected<void> addScaling(const PlannerOptions& options, Report& report, const Progress& progress) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  const int rounds = options.quick ? 1 : 5;
  struct Built {
    double took_ms;
    double obstacles;
  };
  std::vector<Built> built;
  double done = 0.0;
  for (const int tiles : kTiles) {
    auto made = offices(tiles);
    if (!made) return tl::unexpected(made.error());
    const auto world = std::make_shared<const World>(std::move(*made));
    std::vector<double> took_ms;
    double nodes = 0.0;
    for (int round = 0; round < rounds; ++round) {
      const auto start = Planner::Clock::now();
      const auto planner = preparedPlanner(world, *robot);
      took_ms.push_back(std::chrono::duration<double, std::milli>(Planner::Clock::now() - start).count());
      const auto plan = planner->plan({{1.5, 3.6, 0.0}, 0, {6.0, 3.5}, {}, 0, Policy::kFastest},
                                      start + std::chrono::minutes(1));
      if (plan) nodes = static_cast<double>(plan->stats.nodes);
      progress(done += 1.0 / static_cast<double>(kTiles.size() * static_cast<std::size_t>(rounds)));
    }
    built.push_back({quantile(took_ms, 0.5), static_cast<double>(world->obstacles().size())});
    const std::string what = "offices, " + std::to_string(tiles * tiles) + ": ";
    const auto samples = static_cast<unsigned long>(rounds);
    report.rows.push_back({what + "roadmap", built.back().took_ms, "ms", "", {}, 1, samples, {}, {}});
    report.rows.push_back({what + "nodes", nodes, "", "", {}, 1, samples, {}, {}});
  }
  const Built& first = built.front();
  const Built& last = built.back();
  const double growth =
      last.obstacles * std::log(last.obstacles) / (first.obstacles * std::log(first.obstacles));
  const double ratio = last.took_ms / first.took_ms / growth;
  report.rows.push_back({"offices, 1 to 16: the roadmap's time over what n log n allows",
                         ratio,
                         "",
                         "<= 1",
                         ratio <= 1.0,
                         1,
                         static_cast<unsigned long>(rounds),
                         {},
                         {}});
  return {};
}

}  // namespace underway::bench
