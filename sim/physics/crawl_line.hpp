#pragma once

#include "gait/crawl/gait.hpp"
#include "gait/crawl/steering.hpp"
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

/// Whether the heading is kept, from what the IMU says after each cycle.
enum class Heading { kOpenLoop, kFromImu };

/// Crawls until the line's length is behind, at most twice the cycles that should do. The line begins where
/// the robot lies and runs where it headed when it was put down. Throws std::invalid_argument when the robot
/// cannot crawl that gait, turning as the steering may ask.
[[nodiscard]] CrawledLine crawlLine(Simulation& simulation, const gait::CrawlGait& gait, double length_m,
                                    Heading heading);

}  // namespace underway::physics
