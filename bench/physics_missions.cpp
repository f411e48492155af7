#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "bench/local_courses.hpp"
#include "bench/physics_parts.hpp"
#include "geometry/map.hpp"
#include "local/mission.hpp"
#include "planner/planner.hpp"
#include "sim/physics/physical_robot.hpp"

namespace underway::bench {
namespace {

using namespace underway::physics;

constexpr double kLimit_s = 900.0;  // simulated

/// What of our maps needs a crawl and begins standing.
std::vector<Course> crawlingCourses(const PhysicsRun& run, const Robot& robot) {
  std::vector<Course> courses;
  const auto maps = run.robot.parent_path().parent_path() / "maps";
  for (const char* map : {"scenario3.yaml", "flat.yaml"}) {
    const auto all = coursesOf(maps / map, robot).value();
    for (const char* name : {"under_the_table", "and_back", "into_the_box_room", "under_the_bed"})
      for (const Course& course : all)
        if (course.name.ends_with(std::string(", ") + name)) courses.push_back(course);
  }
  return courses;
}

/// How one mission ended.
struct Ended {
  bool has_arrived = false;  ///< in truth, standing or lying as asked
  std::set<std::string> touches;
  double time_s = 0.0;
  double off_m = 0.0;
  std::uint64_t cycles = 0;
};

Ended drive(const PhysicsRun& run, const Course& course, const std::shared_ptr<const Robot>& robot,
            std::uint64_t seed) {
  Planner planner(course.map, robot);
  const auto source = [&](const Request& request, const std::shared_ptr<const World>& world) {
    if (planner.checker()->world().hash() != world->hash()) planner.update(world);
    return planner.findPlan(request, Planner::Clock::now() + std::chrono::seconds(5));
  };
  const gait::CrawlGait gait = gait::cruiseGait();
  ExecutorSettings settings;
  settings.crawl = crawlSettingsOf(gait::CrawlPlayer::make(gait::naoCrawler(), gait).value());
  Mission mission(course.map, robot, course.request, source, settings);
  auto body =
      PhysicalRobot::make(run.robot, *course.truth, robot, course.request.start, gait, conditionsOf(seed))
          .value();
  while (mission.outcome() == Mission::Outcome::kUnderway && body.now_s() < kLimit_s)
    body.step(mission.tick(body.sense()).command);
  const PhysicalTruth& truth = body.truth();
  const double off_m = distance(truth.pose.position(), course.request.goal);
  const bool has_arrived = mission.outcome() == Mission::Outcome::kArrived && truth.is_upright &&
                           isAtGoal(course.request, truth.pose, truth.mode);
  return {has_arrived, truth.touches, body.now_s(), off_m, body.sense().cycles};
}

}  // namespace

void measureMissions(const PhysicsRun& run) {
  const auto robot = std::make_shared<const Robot>(readRobot(run.robot.parent_path() / "nao.yaml").value());
  const auto courses = crawlingCourses(run, *robot);
  double arrived = 0.0;
  double clean = 0.0;
  double cycles = 0.0;
  std::vector<double> off_mm;
  for (std::size_t i = 0; i < run.seeds.size(); ++i) {
    const Ended ended = drive(run, courses[i % courses.size()], robot, run.seeds[i]);
    arrived += ended.has_arrived ? 1.0 : 0.0;
    clean += ended.touches.empty() ? 1.0 : 0.0;
    cycles += static_cast<double>(ended.cycles);
    off_mm.push_back(1000.0 * ended.off_m);
    run.progress(static_cast<double>(i + 1) / static_cast<double>(run.seeds.size()));
  }
  const double count = static_cast<double>(run.seeds.size());
  const std::string all = fmt::format("{:.0f}", count);
  run.ask("missions by the executor, crawls in physics: arrive within 0.05 m and 5 deg", arrived, "seeds",
          all, arrived == count);
  run.ask("missions by the executor, crawls in physics: touch nothing", clean, "seeds", all, clean == count);
  run.tell("missions: from the goal, most", quantile(off_mm, 1.0), "mm");
  run.tell("missions: cycles crawled", cycles, "cycles");
}

}  // namespace underway::bench
