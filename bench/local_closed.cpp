#include <array>
#include <cmath>

#include "bench/local_courses.hpp"
#include "bench/local_parts.hpp"

namespace underway::bench {
namespace {

constexpr std::array kMaps{"scenario1",  "scenario2a", "scenario2b",     "scenario3",
                           "arena_open", "arena_gap",  "arena_corridor", "flat"};

struct Count {
  unsigned long runs = 0;
  unsigned long arrived = 0;
  unsigned long proven = 0;     // said that there is no way, and it is proven
  unsigned long not_found = 0;  // said so, and no search finds one
  unsigned long wrong = 0;      // said so, and there is one
  Collisions collisions;
};

/// What went otherwise than it should, in words; empty if nothing did.
std::string amissIn(const LoopRun& run) {
  if (run.is_disputed) return "the judges disagree whether it touched anything";
  if (run.has_collided) return run.why;
  if (run.has_arrived || run.no_way == NoWay::kProven) return "";
  if (run.no_way == NoWay::kNotFound) return "no way, which is not proven: " + run.why;
  if (run.no_way == NoWay::kFalse) return "no way, wrongly: " + run.why;
  const std::string off = std::to_string(std::lround(1000.0 * run.off_m)) + " mm from the goal";
  return run.why.empty() ? off : off + ": " + run.why;
}

void count(const LocalBench& bench, const std::string& course, unsigned long seed, const LoopRun& run,
           Count& so_far) {
  if (const std::string amiss = amissIn(run); !amiss.empty())
    bench.tell(course + ", seed " + std::to_string(seed) + ": " + amiss);
  ++so_far.runs;
  so_far.arrived += run.has_arrived ? 1 : 0;
  so_far.proven += run.no_way == NoWay::kProven ? 1 : 0;
  so_far.not_found += run.no_way == NoWay::kNotFound ? 1 : 0;
  so_far.wrong += run.no_way == NoWay::kFalse ? 1 : 0;
  so_far.collisions.count(run.has_collided, run.is_disputed);
}

void addRows(const std::string& what, const std::string& does, const Count& so_far, double least_percent,
             Report& report) {
  const double percent = 100.0 * static_cast<double>(so_far.arrived + so_far.proven + so_far.not_found) /
                         static_cast<double>(so_far.runs);
  std::string asked = ">= " + std::to_string(least_percent);
  asked.erase(asked.find_last_not_of('0') + 1);
  if (asked.ends_with('.')) asked.pop_back();
  report.rows.push_back(
      {what + ": " + does, percent, "%", asked, percent >= least_percent, 1, so_far.runs, {}, {}});
  so_far.collisions.addRows(what, report);
}

/// How many of these reported that they are blocked, and how rightly; nothing is asked of them.
void addBlocked(const std::string& what, const Count& so_far, Report& report) {
  const auto add = [&](const std::string& which, unsigned long count) {
    report.rows.push_back(
        {what + ": blocked, " + which, static_cast<double>(count), "runs", "", {}, 1, so_far.runs, {}, {}});
  };
  add("proven in the true world", so_far.proven);
  add("not proven, but a minute's search and the oracle find no way in it", so_far.not_found);
  add("wrongly: there is a way", so_far.wrong);
}

ExecutorSettings settingsFor(double noise) {
  ExecutorSettings settings;
  settings.surroundings.sensor_sigma_m *= noise;
  return settings;
}

std::unique_ptr<Planner> plannerFor(const Course& course, const std::shared_ptr<const Robot>& robot) {
  auto planner = std::make_unique<Planner>(course.map, robot);
  planner->prepare(Planner::Clock::now() + std::chrono::seconds(20));
  return planner;
}

Expected<std::vector<std::vector<Course>>> allCourses(const LocalBench& bench) {
  std::vector<std::vector<Course>> all;
  for (const auto& map : bench.maps(kMaps)) {
    auto courses = coursesOf(map, *bench.robot);
    if (!courses) return tl::unexpected(courses.error());
    all.push_back(std::move(*courses));
  }
  return all;
}

/// So many seeds in each map, its queries in turn.
Count drivePlans(const LocalBench& bench, const std::vector<std::vector<Course>>& maps, double noise) {
  const auto seeds = bench.seeds(1000);
  Count so_far;
  for (const auto& courses : maps) {
    auto planner = plannerFor(courses.front(), bench.robot);
    for (const unsigned long seed : seeds) {
      const Course& course = courses[seed % courses.size()];
      const auto run =
          driveCourse(course, *planner, bench.robot, settingsFor(noise), sim::Flaws{}.times(noise), seed);
      count(bench, course.name, seed, run, so_far);
      bench.progress(static_cast<double>(so_far.runs) / static_cast<double>(seeds.size() * maps.size()));
    }
  }
  return so_far;
}

using Unmapped = Course (*)(const Course&, const Plan&, const std::shared_ptr<const Robot>&, std::uint64_t);

Count driveUnmapped(const LocalBench& bench, const std::vector<std::vector<Course>>& maps,
                    const std::shared_ptr<const Robot>& robot, Unmapped unmapped) {
  const auto seeds = bench.seeds(100);
  Count so_far;
  for (const auto& courses : maps)
    for (const unsigned long seed : seeds) {
      const Course& course = courses[seed % courses.size()];
      auto planner = plannerFor(course, robot);
      const auto plan = planner->findPlan(course.request, Planner::Clock::now() + std::chrono::seconds(5));
      if (!plan) continue;
      const auto run = driveCourse(unmapped(course, *plan, robot, seed), *planner, robot, {}, {}, seed);
      count(bench, course.name, seed, run, so_far);
      bench.progress(static_cast<double>(so_far.runs) / static_cast<double>(seeds.size() * maps.size()));
    }
  return so_far;
}

/// The papers' own trigger in the same room; nothing is asked of it.
void addPapersTrigger(const LocalBench& bench, const Course& course, Report& report) {
  auto planner = plannerFor(course, bench.robot);
  ExecutorSettings settings;
  settings.crawl.papers = PapersTrigger{};
  unsigned long arrived = 0;
  unsigned long collided = 0;
  const auto seeds = bench.seeds(100);
  for (const unsigned long seed : seeds) {
    const auto run = driveCourse(course, *planner, bench.robot, settings, {}, seed);
    arrived += run.has_arrived ? 1 : 0;
    collided += run.has_collided ? 1 : 0;
  }
  const auto add = [&](const std::string& does, double value, const char* unit) {
    report.rows.push_back(
        {"the same by the papers' own trigger: " + does, value, unit, "", {}, 1, seeds.size(), {}, {}});
  };
  add("arrive", 100.0 * static_cast<double>(arrived) / static_cast<double>(seeds.size()), "%");
  add("collide", static_cast<double>(collided), "runs");
}

}  // namespace

Expected<void> addPlans(const LocalBench& bench, Report& report) {
  const auto maps = allCourses(bench);
  if (!maps) return tl::unexpected(maps.error());
  const std::string what = bench.options.map.empty() ? "plans in eight maps" : "plans";
  addRows(what, "arrive", drivePlans(bench, *maps, 1.0), 99.5, report);
  addRows(what + ", all noise doubled", "arrive", drivePlans(bench, *maps, 2.0), 95, report);
  return {};
}

Expected<void> addUnmapped(const LocalBench& bench, Report& report) {
  const auto maps = allCourses(bench);
  if (!maps) return tl::unexpected(maps.error());
  const auto add = [&](const std::string& what, const std::shared_ptr<const Robot>& robot, Unmapped unmapped,
                       double least_percent) -> Expected<void> {
    const Count count = driveUnmapped(bench, *maps, robot, unmapped);
    if (count.runs == 0) return fail(ErrorCode::kTimeout, "no plan to put anything in the way of was found");
    addRows(what, "arrive or report truly blocked", count, least_percent, report);
    addBlocked(what, count, report);
    return {};
  };
  if (const auto added = add("1 to 3 unmapped boxes", bench.robot, withUnmappedBoxes, 98); !added)
    return added;
  auto seeing = *bench.robot;
  seeing.senses.depth = DepthSense{1.5, 3.0};
  return add("1 or 2 unmapped tables, with depth", std::make_shared<const Robot>(seeing), withUnmappedTables,
             95);
}

Expected<void> addTight(const LocalBench& bench, Report& report) {
  const auto seeds = bench.seeds(100);
  for (std::size_t mode = 0; mode < bench.robot->modes.size(); ++mode) {
    const auto course = narrowCourse(*bench.robot, static_cast<ModeId>(mode));
    if (!course) return tl::unexpected(course.error());
    auto planner = plannerFor(*course, bench.robot);
    Count so_far;
    const std::string what = "gap of " + course->name + " body and 6 cm";
    for (const unsigned long seed : seeds) {
      count(bench, what, seed, driveCourse(*course, *planner, bench.robot, {}, {}, seed), so_far);
      bench.progress(static_cast<double>(so_far.runs) / static_cast<double>(seeds.size()));
    }
    addRows(what, "arrive", so_far, 98, report);
    if (mode + 1 == bench.robot->modes.size()) addPapersTrigger(bench, *course, report);
  }
  return {};
}

}  // namespace underway::bench
