#include <algorithm>
#include <cmath>

#include "bench/local_parts.hpp"
#include "bench/minimiser.hpp"

namespace underway::bench {
namespace {

void addMinimiser(const LocalBench& bench, Report& report) {
  const auto cases = bench.seeds(100'000);
  double worst = 0.0;
  for (const unsigned long seed : cases) {
    const HeadingCase any = randomHeadingCase(seed);
    const HeadingOptimum optimum(any.settings, any.scan.beams);
    const double closed = optimum.of(any.scan, any.goal, any.facing_rad).heading_rad;
    const double searched = leastCostHeading(any.scan, any.goal, any.facing_rad, any.settings);
    worst = std::max(worst, std::abs(normalizedAngle(closed - searched)));
    if (seed % 64 == 0)
      bench.progress(static_cast<double>(seed - cases.front()) / static_cast<double>(cases.size()));
  }
  report.rows.push_back({"heading against a numerical minimiser of (3.6), furthest",
                         worst,
                         "rad",
                         "<= 1e-6",
                         worst <= 1e-6,
                         1,
                         cases.size(),
                         {},
                         {}});
}

}  // namespace

Expected<void> addHeading(const LocalBench& bench, Report& report) {
  addMinimiser(bench, report);
  return addTicks(bench, report);
}

}  // namespace underway::bench
