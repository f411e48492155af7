#include <functional>

#include "bench/local_parts.hpp"
#include "bench/local_run.hpp"
#include "geometry/map.hpp"

namespace underway::bench {
namespace {

constexpr double kLimit_s = 3600.0;  // simulated

struct Count {
  unsigned long arrived = 0;
  Collisions collisions;
  std::vector<double> times_s;
};

using RoomOf = std::function<PureRoom(std::uint64_t)>;

Count countOf(const LocalBench& bench, const RoomOf& room, const PureSettings& settings,
              unsigned long asked) {
  Count count;
  const auto seeds = bench.seeds(asked);
  for (const unsigned long seed : seeds) {
    const PureRun run = drivePurely(room(seed), bench.robot, settings, seed, kLimit_s);
    count.arrived += run.has_arrived ? 1 : 0;
    count.collisions.count(run.has_collided, run.is_disputed);
    count.times_s.push_back(run.time_s);
    bench.progress(static_cast<double>(count.times_s.size()) / static_cast<double>(seeds.size()));
  }
  return count;
}

void addRows(const std::string& what, const Count& count, double least_percent, Report& report) {
  const auto seeds = count.times_s.size();
  const double percent = 100.0 * static_cast<double>(count.arrived) / static_cast<double>(seeds);
  const auto asked = ">= " + std::to_string(static_cast<int>(least_percent));
  report.rows.push_back({what + ": arrive", percent, "%", asked, percent >= least_percent, 1, seeds, {}, {}});
  count.collisions.addRows(what, report);
  report.rows.push_back(
      {what + ": simulated time, p50", quantile(count.times_s, 0.5), "s", "", {}, 1, seeds, {}, {}});
}

Expected<PureRoom> arena(const LocalBench& bench, const std::string& name) {
  const auto map = readMap(bench.options.data / "maps" / (name + ".yaml"));
  if (!map) return tl::unexpected(map.error());
  const Query& query = map->queries.front();
  return PureRoom{std::make_shared<const World>(map->world), query.start, query.goal};
}

}  // namespace

Expected<void> addPure(const LocalBench& bench, Report& report) {
  constexpr unsigned long kSeeds = 100;
  for (const std::string name : {"arena_open", "arena_gap", "arena_corridor"}) {
    const auto room = arena(bench, name);
    if (!room) return tl::unexpected(room.error());
    addRows(name + ", GODZILA alone",
            countOf(
                bench, [&](std::uint64_t) { return *room; }, {}, kSeeds),
            100, report);
  }
  addRows("random 73 cm gaps, with escape", countOf(bench, randomGap, {}, kSeeds), 95, report);
  PureSettings keeping;
  keeping.keeps_traps = true;
  addRows("a wall squarely in front, traps kept", countOf(bench, wallInFront, keeping, kSeeds), 90, report);
  addRows("a U, traps kept", countOf(bench, uInFront, keeping, kSeeds), 90, report);
  PureSettings paper;
  paper.godzila = table7();
  addRows("arena_gap, with Table 7's values",
          countOf(
              bench, [&](std::uint64_t) { return *arena(bench, "arena_gap"); }, paper, 20),
          0, report);
  return {};
}

}  // namespace underway::bench
