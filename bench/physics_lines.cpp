#include <spdlog/fmt/fmt.h>

#include <numbers>

#include "bench/physics_parts.hpp"
#include "gait/crawl/crawler.hpp"
#include "sim/physics/crawl_line.hpp"

namespace underway::bench {
namespace {

using namespace underway::physics;

constexpr double kLine_m = 2.0;
constexpr double kMostAside_m = 0.030;
constexpr double kMostHeading_rad = 3.0 * std::numbers::pi / 180.0;

CrawledLine crawl(const PhysicsRun& run, std::uint64_t seed, bool keeps_heading) {
  Simulation simulation = Simulation::make(run.robot, {}, conditionsOf(seed)).value();
  gait::Steering steering;
  if (!keeps_heading) steering.gain = 0.0;
  auto player = gait::CrawlPlayer::make(gait::naoCrawler(), gait::cruiseGait(), steering).value();
  simulation.start(player.lie(0.0), Posture::kLying, {});
  return crawlLine(simulation, player, kLine_m);
}

}  // namespace

void measureLines(const PhysicsRun& run) {
  double done = 0.0;
  for (const auto& [keeps_heading, name] : {std::pair(false, "open loop"), std::pair(true, "heading kept")}) {
    std::vector<double> aside_mm;
    std::vector<double> heading_deg;
    double kept = 0.0;
    for (const std::uint64_t seed : run.seeds) {
      const CrawledLine line = crawl(run, seed, keeps_heading);
      aside_mm.push_back(1000.0 * line.most_aside_m);
      heading_deg.push_back(line.most_heading_rad * 180.0 / std::numbers::pi);
      kept += line.most_aside_m <= kMostAside_m && line.most_heading_rad <= kMostHeading_rad ? 1.0 : 0.0;
      run.progress(done += 0.5 / static_cast<double>(run.seeds.size()));
    }
    const std::string what = fmt::format("2 m, {}: ", name);
    const double count = static_cast<double>(run.seeds.size());
    if (keeps_heading)
      run.ask(what + "within 30 mm and 3 deg all the way", kept, "seeds", fmt::format("{:.0f}", count),
              kept == count);
    else
      run.tell(what + "within 30 mm and 3 deg all the way", kept, "seeds");
    run.tell(what + "furthest aside, median", quantile(aside_mm, 0.5), "mm");
    run.tell(what + "furthest aside, most", quantile(aside_mm, 1.0), "mm");
    run.tell(what + "heading off, median", quantile(heading_deg, 0.5), "deg");
    run.tell(what + "heading off, most", quantile(heading_deg, 1.0), "deg");
  }
}

}  // namespace underway::bench
