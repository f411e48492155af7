#include "sim/physics/crawl_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gait/crawl/crawler.hpp"

namespace underway::physics {
namespace {

constexpr double kJoin_s = 0.1;

gait::JointTable cycle(const gait::CrawlGait& gait, double turn_rad) {
  gait::CrawlGait turning = gait;
  turning.turn_rad = turn_rad;
  auto motion = gait::crawlMotion(gait::naoCrawler(), turning);
  if (!motion) throw std::invalid_argument("NAO cannot crawl so: " + motion.error().message);
  return std::move(*motion);
}

/// The next motion, led to from where the last one ended: turns that differ begin with other angles.
gait::JointTable joined(const gait::JointTable& last, const gait::JointTable& next) {
  gait::JointTable table(next.joints());
  table.append(0.0, last.angles(last.rows() - 1));
  for (std::size_t row = 0; row < next.rows(); ++row)
    table.append(kJoin_s + next.time(row) - next.time(0), next.angles(row));
  return table;
}

void note(CrawledLine& line, const Pose& start, const Pose& now, Recording&& recording) {
  const Pose made = relative(start, now);
  ++line.cycles;
  line.ahead_m = made.x;
  line.most_aside_m = std::max(line.most_aside_m, std::abs(made.y));
  line.most_heading_rad = std::max(line.most_heading_rad, std::abs(made.yaw));
  line.recordings.push_back(std::move(recording));
}

}  // namespace

CrawledLine crawlLine(Simulation& simulation, const gait::CrawlGait& gait, double length_m, Heading heading) {
  CrawledLine line;
  Pose start = simulation.now().lying;
  start.yaw -= simulation.imuHeading();
  const gait::Steering steering;
  const int most_cycles = static_cast<int>(std::ceil(2.0 * length_m / steering.advance_m));
  gait::JointTable last = cycle(gait, 0.0);
  gait::OffLine off{simulation.imuHeading(), 0.0};
  while (line.ahead_m < length_m && line.cycles < most_cycles) {
    const double turn = heading == Heading::kFromImu ? gait::turnTowards(off, steering) : 0.0;
    const gait::JointTable next = cycle(gait, turn);
    Recording recording = simulation.play(joined(last, next), Posture::kLying);
    last = next;
    off = gait::reckon(off, simulation.imuHeading(), turn, steering);
    note(line, start, simulation.now().lying, std::move(recording));
  }
  return line;
}

}  // namespace underway::physics
