#include "gait/crawl/steering.hpp"

#include <algorithm>
#include <cmath>

namespace underway::gait {

double turnTowards(const OffLine& off, const Steering& steering) {
  const double aim = std::clamp(-off.left_m / steering.return_m, -steering.aim_rad, steering.aim_rad);
  return std::clamp(-steering.gain * (off.heading_rad - aim), -steering.most_turn_rad,
                    steering.most_turn_rad);
}

OffLine reckon(const OffLine& before, double heading_rad, double turn_rad, const Steering& steering) {
  const double mean_rad = 0.5 * (before.heading_rad + heading_rad);
  return {heading_rad,
          before.left_m + steering.advance_m * std::sin(mean_rad) + steering.aside_m_per_rad * turn_rad};
}

}  // namespace underway::gait
