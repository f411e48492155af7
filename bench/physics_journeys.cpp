#include <spdlog/fmt/fmt.h>

#include <fstream>
#include <numbers>
#include <optional>

#include "bench/physics_parts.hpp"
#include "gait/crawl/crawler.hpp"
#include "sim/physics/journey.hpp"
#include "sim/physics/picture.hpp"

namespace underway::bench {
namespace {

using namespace underway::physics;

void enclose(std::optional<BodyBox>& all, const BodyBox& more) {
  all = all ? BodyBox{hull(all->x, more.x), hull(all->y, more.y), hull(all->z, more.z)} : more;
}

/// A switch over all seeds.
struct SwitchFigures {
  double duration_s = 0.0;
  std::vector<double> x_m, y_m, yaw_deg;
  std::optional<BodyBox> box;

  void add(const Recording& recording, const Pose& displacement) {
    duration_s = recording.duration_s;
    x_m.push_back(displacement.x);
    y_m.push_back(displacement.y);
    yaw_deg.push_back(displacement.yaw * 180.0 / std::numbers::pi);
    enclose(box, sweptBox(recording));
  }
};

void tellBox(const PhysicsRun& run, const std::string& name, const BodyBox& box) {
  for (const auto& [axis, range] : {std::pair('x', box.x), std::pair('y', box.y), std::pair('z', box.z)}) {
    run.tell(name + ": box, " + axis + " from", range.min, "m");
    run.tell(name + ": box, " + axis + " to", range.max, "m");
  }
}

void tellSwitch(const PhysicsRun& run, const char* name, const SwitchFigures& figures) {
  const auto what = [&](const char* of) { return fmt::format("{}: {}", name, of); };
  run.tell(what("duration"), figures.duration_s, "s");
  const auto tellAll = [&](const std::vector<double>& values, const char* of, const char* unit) {
    run.tell(what(of) + ", least", quantile(values, 0.0), unit);
    run.tell(what(of) + ", median", quantile(values, 0.5), unit);
    run.tell(what(of) + ", greatest", quantile(values, 1.0), unit);
  };
  tellAll(figures.x_m, "displacement x", "m");
  tellAll(figures.y_m, "displacement y", "m");
  tellAll(figures.yaw_deg, "displacement yaw", "deg");
  tellBox(run, name, *figures.box);
}

void draw(const PhysicsRun& run, const char* name, const Recording& recording) {
  if (run.pictures.empty()) return;
  const auto model = makeModel(run.robot, {}, 1.0);
  std::ofstream(std::filesystem::path(run.pictures) / name) << drawSide(**model, spread(recording, 16));
}

}  // namespace

void measureJourneys(const PhysicsRun& run) {
  SwitchFigures down;
  SwitchFigures up;
  std::optional<BodyBox> crawl;
  double clean = 0.0;
  double done = 0.0;
  for (const std::uint64_t seed : run.seeds) {
    const Journey journey = crawlUnder(run.robot, {}, gait::cruiseGait(), conditionsOf(seed)).value();
    clean += journey.stands && journey.touches.empty() ? 1.0 : 0.0;
    down.add(journey.down, journey.lying_after_down);
    for (const Recording& cycle : journey.crawl.recordings) enclose(crawl, sweptBox(cycle));
    up.add(journey.up, journey.standing_after_up);
    if (seed == run.seeds.front()) {
      draw(run, "down.svg", journey.down);
      draw(run, "crawl.svg", journey.crawl.recordings.at(1));
      draw(run, "up.svg", journey.up);
    }
    run.progress(done += 1.0 / static_cast<double>(run.seeds.size()));
  }
  const double count = static_cast<double>(run.seeds.size());
  run.ask("down, under a table of 1 m with 220 mm clear, up: touching nothing", clean, "seeds",
          fmt::format("{:.0f}", count), clean == count);
  tellBox(run, "cruise, steered", *crawl);
  tellSwitch(run, "frontal to crawl", down);
  tellSwitch(run, "crawl to frontal", up);
}

}  // namespace underway::bench
