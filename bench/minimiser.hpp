#pragma once

#include <cstdint>

#include "local/godzila/heading.hpp"

namespace underway::bench {

/// The sum of the costs (3.7), (3.9), (3.10) and (3.11) of one heading, beam by beam with the distances
/// between unit vectors as they are printed, and no more of its structure used than that.
[[nodiscard]] long double costOf(long double heading_rad, const Scan& scan, const Bearing& goal,
                                 double facing_rad, const GodzilaSettings& settings);

/// The heading of least cost, found by sampling the circle and a golden section [rad].
[[nodiscard]] double leastCostHeading(const Scan& scan, const Bearing& goal, double facing_rad,
                                      const GodzilaSettings& settings);

/// A scan, a goal and settings at random.
struct HeadingCase {
  Scan scan;
  Bearing goal;
  double facing_rad = 0.0;
  GodzilaSettings settings;
};
[[nodiscard]] HeadingCase randomHeadingCase(std::uint64_t seed);

}  // namespace underway::bench
