#pragma once

#include "gait/crawl/player.hpp"
#include "sim/physics/simulation.hpp"

namespace underway::physics {

/// What happened on a straight crawl.
struct CrawledLine {
  int cycles = 0;
  double ahead_m = 0.0;               ///< along the line, from the start [m]
  double most_aside_m = 0.0;          ///< furthest from the line after a cycle, to either side [m]
  double most_heading_rad = 0.0;      ///< greatest error of heading after a cycle, to either side [rad]
  std::vector<Recording> recordings;  ///< one a cycle
};

/// Crawls until the line's length is behind, at most twice the cycles that should do. The robot lies; the
/// line begins there and runs where it headed when it was put down, and the player, which has been told so,
/// keeps it from what the IMU says after each cycle.
[[nodiscard]] CrawledLine crawlLine(Simulation& simulation, gait::CrawlPlayer& player, double length_m);

}  // namespace underway::physics
