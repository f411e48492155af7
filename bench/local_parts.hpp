#pragma once

#include <functional>
#include <memory>
#include <ranges>
#include <span>
#include <vector>

#include "bench/local.hpp"
#include "geometry/robot.hpp"

/// The parts of `underway bench local`, a file each. Every one adds its rows to the report.
namespace underway::bench {

/// What every part is given.
struct LocalBench {
  const LocalOptions& options;
  std::shared_ptr<const Robot> robot;  ///< NAO with its lidar at the waist
  std::function<void(double)> progress;
  std::function<void(const std::string&)> tell;

  /// As many seeds as a figure asks for, or a small share of them, or as many as the user does.
  [[nodiscard]] auto seeds(unsigned long asked) const {
    const unsigned long share = options.quick ? (asked + 19) / 20 : asked;
    return std::views::iota(options.seed, options.seed + (options.seeds > 0 ? options.seeds : share));
  }
  /// The files of these maps, or the one the user asks for.
  [[nodiscard]] std::vector<std::filesystem::path> maps(std::span<const char* const> names) const;
};

/// In how many of some runs the robot collides, by the word of either of its judges, and in how many the two
/// disagree by more than touching: 0 are asked for.
struct Collisions {
  unsigned long runs = 0;
  unsigned long collided = 0;
  unsigned long disputed = 0;

  void count(bool has_collided, bool is_disputed);
  void addRows(const std::string& what, Report& report) const;
};

/// The closed form of the heading against a numerical minimiser; a tick's time.
[[nodiscard]] Expected<void> addHeading(const LocalBench& bench, Report& report);
/// The second half of it.
[[nodiscard]] Expected<void> addTicks(const LocalBench& bench, Report& report);
/// GODZILA without a plan: arenas, gaps, a wall, a U.
[[nodiscard]] Expected<void> addPure(const LocalBench& bench, Report& report);
/// Plans executed in the rooms of maps/, also with doubled noise.
[[nodiscard]] Expected<void> addPlans(const LocalBench& bench, Report& report);
/// The same with things in the way that the map does not have.
[[nodiscard]] Expected<void> addUnmapped(const LocalBench& bench, Report& report);
/// Gaps that leave a body 6 cm, for each mode.
[[nodiscard]] Expected<void> addTight(const LocalBench& bench, Report& report);
/// How long it takes from 'blocked' to the new plan's first command, with a server over DDS.
[[nodiscard]] Expected<void> addBlocked(const LocalBench& bench, Report& report);

}  // namespace underway::bench
