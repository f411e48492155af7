#include <spdlog/fmt/fmt.h>

#include "bench/physics_parts.hpp"
#include "sim/physics/crawl_figures.hpp"

namespace underway::bench {
namespace {

using namespace underway::physics;

constexpr std::uint64_t kSeed = 10;  // friction in the middle
constexpr int kCycles = 3;

CrawlFigures figuresOf(const PhysicsRun& run, gait::CrawlGait gait, double push_s) {
  gait.times.push_s = push_s;
  Simulation simulation = Simulation::make(run.robot, {}, conditionsOf(kSeed)).value();
  return measureCrawl(simulation, gait, kCycles);
}

void compare(const PhysicsRun& run, const std::string& what, double value, double nominal) {
  run.report.rows.push_back({what, value, "N^2 m^2 s", "", std::nullopt, kSeed, kCycles - 1,
                             Row::Peer{"nominal", nominal}, value / nominal});
}

}  // namespace

void measureTorques(const PhysicsRun& run) {
  constexpr int kDurations = 10;
  for (int push_s = 1; push_s <= kDurations; ++push_s) {
    const CrawlFigures nominal = figuresOf(run, gait::nominalGait(), push_s);
    const CrawlFigures steady = figuresOf(run, gait::cruiseGait(), push_s);
    compare(run, fmt::format("cruise, push of {} s: torque, weights 1 1 1 5", push_s), steady.torque_cost,
            nominal.torque_cost);
    compare(run, fmt::format("cruise, push of {} s: torque, weights 1 1 1 1", push_s), steady.even_cost,
            nominal.even_cost);
    run.progress(static_cast<double>(push_s) / kDurations);
  }
}

}  // namespace underway::bench
