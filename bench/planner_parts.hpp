#pragma once

#include <memory>

#include "bench/planner.hpp"
#include "geometry/map.hpp"
#include "planner/planner.hpp"

/// The parts of `underway bench planner`, a file each. Every one adds its rows to the report.
namespace underway::bench {

/// Scenario 3 from nothing to a certified plan, over many seeds.
[[nodiscard]] Expected<void> addCold(const PlannerOptions& options, Report& report, const Progress& progress);
/// Cost against the oracle's, each policy, random queries in the rooms of maps/.
[[nodiscard]] Expected<void> addCost(const PlannerOptions& options, Report& report, const Progress& progress);
/// Warm queries on roadmaps of given sizes.
[[nodiscard]] Expected<void> addWarm(const PlannerOptions& options, Report& report, const Progress& progress);
/// Two real buildings with NAO: a thousand random queries each.
[[nodiscard]] Expected<void> addBuildings(const PlannerOptions& options, Report& report,
                                          const Progress& progress);
/// Processor time that goes on after the deadline.
[[nodiscard]] Expected<void> addDeadlines(const PlannerOptions& options, Report& report,
                                          const Progress& progress);
/// One box moved about: what the new snapshot costs, and what looking at everything again would.
[[nodiscard]] Expected<void> addChange(const PlannerOptions& options, Report& report,
                                       const Progress& progress);
/// Gaps that leave a body 2, 4 and 8 cm, for each mode.
[[nodiscard]] Expected<void> addNarrow(const PlannerOptions& options, Report& report,
                                       const Progress& progress);
/// What building a roadmap costs as an office grows.
[[nodiscard]] Expected<void> addScaling(const PlannerOptions& options, Report& report,
                                        const Progress& progress);

/// NAO, the default robot.
[[nodiscard]] Expected<std::shared_ptr<const Robot>> naoOf(const PlannerOptions& options);
/// A map's world, to be shared.
[[nodiscard]] Expected<std::shared_ptr<const World>> worldOf(const std::filesystem::path& map);

/// A planner whose roadmap covers the floor, grown for a minute at most.
[[nodiscard]] std::unique_ptr<Planner> preparedPlanner(const std::shared_ptr<const World>& world,
                                                       const std::shared_ptr<const Robot>& robot,
                                                       GrowthSettings settings = {});

}  // namespace underway::bench
