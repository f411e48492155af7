#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bench/physics_parts.hpp"
#include "sim/physics/crawl_figures.hpp"

namespace underway::bench {
namespace {

using namespace underway::physics;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kCycles = 4;

CrawlFigures figuresOf(const PhysicsRun& run, const gait::CrawlGait& gait, std::uint64_t seed,
                       const Scene& scene) {
  Simulation simulation = Simulation::make(run.robot, scene, conditionsOf(seed)).value();
  return measureCrawl(simulation, gait, kCycles);
}

/// The least and the greatest over the seeds.
struct Spread {
  Range advance_m{1e9, -1e9};
  double highest_m = 0.0;
  double most_turn_rad = 0.0;
  double most_aside_m = 0.0;
  double toe_slip_m = 0.0;
  double elbow_slip_m = 0.0;
  double saturated_s = 0.0;
  BodyBox box;

  void add(const CrawlFigures& f) {
    advance_m = hull(advance_m, {f.advance_m, f.advance_m});
    highest_m = std::max(highest_m, f.highest_m);
    most_turn_rad = std::max(most_turn_rad, std::abs(f.turn_rad));
    most_aside_m = std::max(most_aside_m, std::abs(f.aside_m));
    toe_slip_m = std::max(toe_slip_m, f.toe_slip_m);
    elbow_slip_m = std::max(elbow_slip_m, f.elbow_slip_m);
    saturated_s = std::max(saturated_s, f.saturated_s);
    box = {hull(box.x, f.box.x), hull(box.y, f.box.y), hull(box.z, f.box.z)};
  }
};

void tellGait(const PhysicsRun& run, const gait::CrawlGait& gait, const Spread& spread) {
  const auto what = [&](const char* of) { return gait.name + ": " + of; };
  const Range mm{1000.0 * spread.advance_m.min, 1000.0 * spread.advance_m.max};
  if (gait.name == "nominal") {
    run.ask(what("net advance a cycle, least of the seeds"), mm.min, "mm", "60 to 85", mm.min >= 60.0);
    run.ask(what("net advance a cycle, greatest"), mm.max, "mm", "60 to 85", mm.max <= 85.0);
  } else {
    run.tell(what("net advance a cycle, least of the seeds"), mm.min, "mm");
    run.tell(what("net advance a cycle, greatest"), mm.max, "mm");
  }
  run.ask(what("highest point"), 1000.0 * spread.highest_m, "mm", "<= 207", spread.highest_m <= 0.207);
  run.tell(what("cycle"), gait.times.cycle(), "s");
  run.tell(what("aside a cycle, most"), 1000.0 * spread.most_aside_m, "mm");
  run.tell(what("turn a cycle, most"), spread.most_turn_rad / kDegree, "deg");
  run.tell(what("toes slide in the push, most"), 1000.0 * spread.toe_slip_m, "mm");
  run.tell(what("elbows slide in the push, most"), 1000.0 * spread.elbow_slip_m, "mm");
  run.tell(what("servos saturated in the push, most"), spread.saturated_s, "s");
  run.tell(what("box, x from"), spread.box.x.min, "m");
  run.tell(what("box, x to"), spread.box.x.max, "m");
  run.tell(what("box, y from"), spread.box.y.min, "m");
  run.tell(what("box, y to"), spread.box.y.max, "m");
}

void tellSlope(const PhysicsRun& run, const char* name, const Ground& ground) {
  Spread spread;
  for (const std::uint64_t seed : {run.seeds.front(), run.seeds.back()})
    spread.add(figuresOf(run, gait::cruiseGait(), seed, {.ground = ground, .obstacles = {}}));
  const std::string what = fmt::format("cruise, {}: ", name);
  run.tell(what + "net advance a cycle, least", 1000.0 * spread.advance_m.min, "mm");
  run.tell(what + "net advance a cycle, greatest", 1000.0 * spread.advance_m.max, "mm");
  run.tell(what + "turn a cycle, most", spread.most_turn_rad / kDegree, "deg");
}

void tellCurve(const PhysicsRun& run) {
  gait::CrawlGait gait = gait::cruiseGait();
  gait.turn_rad = 6.0 * kDegree;
  double least = 1e9;
  double radius_m = 0.0;
  for (const std::uint64_t seed : {run.seeds.front(), run.seeds.back()}) {
    const CrawlFigures figures = figuresOf(run, gait, seed, {});
    least = std::min(least, figures.turn_rad);
    radius_m = std::max(radius_m, figures.advance_m / figures.turn_rad);
  }
  run.tell("cruise, turning 6 deg a push: the heading turns a cycle, least", least / kDegree, "deg");
  run.tell("cruise, turning 6 deg a push: radius of the curve, greatest", radius_m, "m");
}

}  // namespace

void measureGaits(const PhysicsRun& run) {
  const std::array gaits{gait::nominalGait(), gait::cruiseGait()};
  double done = 0.0;
  for (const gait::CrawlGait& gait : gaits) {
    Spread spread;
    for (const std::uint64_t seed : run.seeds) {
      spread.add(figuresOf(run, gait, seed, {}));
      run.progress(done += 0.8 / static_cast<double>(gaits.size() * run.seeds.size()));
    }
    tellGait(run, gait, spread);
  }
  constexpr double kSlope_rad = 5.0 * kDegree;
  tellSlope(run, "5 deg uphill", {.uphill_rad = kSlope_rad, .leftward_rad = 0.0});
  tellSlope(run, "5 deg downhill", {.uphill_rad = -kSlope_rad, .leftward_rad = 0.0});
  tellSlope(run, "5 deg across", {.uphill_rad = 0.0, .leftward_rad = kSlope_rad});
  tellCurve(run);
}

}  // namespace underway::bench
