#include "local/godzila/straight_line.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

double freeAlong(const Scan& scan, double bearing_rad, double half_width_m, double most_m) {
  const double width_rad = std::abs(scan.beams.step_rad);
  double free = most_m;
  forEachBeam(scan.beams, -bearing_rad, [&](std::size_t i, Point direction) {
    const double range = scan.ranges_m[i];
    if (direction.x <= 0.0 || range * direction.x >= free) return;
    // Far away a beam may pass on either side of a thin thing: its neighbour's distance counts as its own.
    if (range * std::abs(direction.y) < half_width_m + range * width_rad) free = range * direction.x;
  });
  return free;
}

bool isLaneFree(const Scan& scan, const Bearing& goal, double half_width_m) {
  const double reach = 0.5 * static_cast<double>(scan.beams.count) * scan.beams.step_rad;
  if (std::abs(goal.bearing_rad) > reach) return false;  // it lies where nothing is seen
  return freeAlong(scan, goal.bearing_rad, half_width_m, goal.range_m) >= goal.range_m;
}

std::optional<Bearing> StraightLine::intermediate(const Scan& scan, const Bearing& goal, double now_s) {
  if (!isLaneFree(scan, goal, settings_.half_width_m)) {
    reset();
    return std::nullopt;
  }
  if (!begun_s_ || now_s - *begun_s_ >= allowed_s_) {
    begun_s_ = now_s;
    allowed_s_ = std::max(goal.range_m / settings_.expected_mps, 1.0);
  }
  const double lambda = (now_s - *begun_s_) / allowed_s_;
  const double ahead = std::max(lambda * goal.range_m, settings_.least_ahead_m);
  return Bearing{std::min(ahead, goal.range_m), goal.bearing_rad};
}

}  // namespace underway
