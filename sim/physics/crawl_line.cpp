#include "sim/physics/crawl_line.hpp"

#include <algorithm>
#include <cmath>

namespace underway::physics {
namespace {

void note(CrawledLine& line, const Pose& start, const Pose& now, Recording&& recording) {
  const Pose made = relative(start, now);
  ++line.cycles;
  line.ahead_m = made.x;
  line.most_aside_m = std::max(line.most_aside_m, std::abs(made.y));
  line.most_heading_rad = std::max(line.most_heading_rad, std::abs(made.yaw));
  line.recordings.push_back(std::move(recording));
}

}  // namespace

CrawledLine crawlLine(Simulation& simulation, gait::CrawlPlayer& player, double length_m) {
  CrawledLine line;
  Pose start = simulation.now().lying;
  start.yaw -= simulation.imuHeading();
  const int most_cycles = static_cast<int>(std::ceil(2.0 * length_m / player.advance()));
  while (line.ahead_m < length_m && line.cycles < most_cycles) {
    Recording recording = simulation.play(player.cycle(simulation.imuHeading()), Posture::kLying);
    note(line, start, simulation.now().lying, std::move(recording));
  }
  return line;
}

}  // namespace underway::physics
