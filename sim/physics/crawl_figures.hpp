#pragma once

#include <array>

#include "gait/crawl/gait.hpp"
#include "sim/physics/simulation.hpp"

namespace underway::physics {

/// What a crawl does in physics, cycle by cycle; means are over all cycles but the first, which begins at
/// rest in a pose that the crawl itself does not come by.
struct CrawlFigures {
  double advance_m = 0.0;  ///< net, ahead, a cycle
  double aside_m = 0.0;    ///< net, to the left, a cycle
  double turn_rad = 0.0;   ///< of the heading, to the left, a cycle
  double highest_m = 0.0;  ///< the highest point of any contact shape at any time
  BodyBox box;             ///< swept in a cycle, in the body frame at its start
  double toe_slip_m =
      0.0;  ///< of the toes in the push: the way they slide while they bear weight, the worse side
  double elbow_slip_m = 0.0;       ///< of the forearms in the push, the worse side
  double torque_cost = 0.0;        ///< of the push, with the paper's weights 1 1 1 5 [N^2 m^2 s]
  double even_cost = 0.0;          ///< of the push, weights 1 1 1 1
  double saturated_s = 0.0;        ///< in the push, of all servos together, a cycle
  std::array<double, 4> rms_nm{};  ///< in the push: ankle, knee, hip, shoulder pitch
};

/// Puts the robot down and lets it crawl. Throws std::invalid_argument unless there are at least two cycles,
/// and when NAO cannot crawl so.
[[nodiscard]] CrawlFigures measureCrawl(Simulation& simulation, const gait::CrawlGait& gait, int cycles);

}  // namespace underway::physics
