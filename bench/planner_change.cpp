#include <algorithm>
#include <chrono>
#include <random>

#include "bench/planner_parts.hpp"

namespace underway::bench {
namespace {

constexpr double kSnapshot_ms = 0.5;  // asked
constexpr double kRevalidation_ms = 10.0;
constexpr double kNodes = 5000.0;  // of the roadmap, about

double millisecondsSince(Planner::Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Planner::Clock::now() - start).count();
}

/// A room with a box that is moved about, and a roadmap of about as many nodes as asked.
std::unique_ptr<Planner> plannerWith(const std::shared_ptr<const World>& world,
                                     const std::shared_ptr<const Robot>& robot) {
  GrowthSettings settings;
  std::unique_ptr<Planner> planner;
  for (settings.sites_per_m2 = 1.0; settings.sites_per_m2 < 100.0; settings.sites_per_m2 *= 1.2) {
    planner = preparedPlanner(world, robot, settings);
    if (static_cast<double>(planner->roadmap()->node_count) >= kNodes) break;
  }
  return planner;
}

}  // namespace

Expected<void> addChange(const PlannerOptions& options, Report& report, const Progress& progress) {
  const auto robot = naoOf(options);
  if (!robot) return tl::unexpected(robot.error());
  const auto room = worldOf(options.data / "maps" / "flat.yaml");
  if (!room) return tl::unexpected(room.error());
  auto with_box = (*room)->added({"moved", {{1.0, 1.0, 0.25}, {0.4, 0.4, 0.5}, {}}});
  if (!with_box) return tl::unexpected(with_box.error());
  auto world = std::make_shared<const World>(std::move(*with_box));
  const auto planner = plannerWith(world, *robot);

  const std::size_t moves = options.quick ? 50 : 1000;
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
  };
  std::vector<double> snapshot_ms;
  std::vector<double> looked_at;
  std::vector<double> changed;
  for (std::size_t i = 0; i < moves; ++i) {
    const Bounds& bounds = world->bounds();
    const Point at = transform(bounds.corner, {between(0.0, bounds.width_m), between(0.0, bounds.height_m)});
    auto moved = world->moved("moved", {{at.x, at.y, 0.25}, {0.4, 0.4, 0.5}, {0.0, 0.0, between(-3.0, 3.0)}});
    if (!moved) return tl::unexpected(moved.error());
    world = std::make_shared<const World>(std::move(*moved));
    const auto start = Planner::Clock::now();
    const Repair repair = planner->update(world);
    snapshot_ms.push_back(millisecondsSince(start));
    looked_at.push_back(static_cast<double>(repair.checked));
    changed.push_back(static_cast<double>(repair.closed + repair.opened));
    progress(static_cast<double>(i + 1) / static_cast<double>(moves));
  }
  const Checker checker(world, *robot);
  const Stances stances(checker, Policy::kFastest);
  std::vector<double> whole_ms;
  for (int i = 0; i < 21; ++i) {
    Repair repair;
    const auto start = Planner::Clock::now();
    static_cast<void>(revalidated(*planner->roadmap(), stances, checker, repair));
    whole_ms.push_back(millisecondsSince(start));
  }
  const auto add = [&](const std::string& what, double value, const char* unit, const char* goal,
                       std::optional<bool> met) {
    report.rows.push_back({"one box moved: " + what, value, unit, goal, met, 1, moves, {}, {}});
  };
  add("nodes", static_cast<double>(planner->roadmap()->node_count), "", "", {});
  const double p50 = quantile(snapshot_ms, 0.5);
  add("new snapshot, p50", p50, "ms", "<= 0.5", p50 <= kSnapshot_ms);
  add("new snapshot, p99", quantile(snapshot_ms, 0.99), "ms", "", {});
  add("links looked at again, p50", quantile(looked_at, 0.5), "", "", {});
  add("ways closed or opened, p50", quantile(changed, 0.5), "", "", {});
  const double whole = quantile(whole_ms, 0.5);
  add("full revalidation, p50", whole, "ms", "<= 10", whole <= kRevalidation_ms);
  return {};
}

}  // namespace underway::bench
