#include "server/robot/beams.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace underway {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

/// Beams of the standard scan that look into a sector get no further than a range. They do not look back, so
/// no sector has to go round.
void shorten(Scan& scan, double middle_rad, double half_rad, double range_m) {
  const Beams& beams = scan.beams;
  const double first = (middle_rad - half_rad - beams.first_rad) / beams.step_rad;
  const double last = (middle_rad + half_rad - beams.first_rad) / beams.step_rad;
  constexpr double kRound = 1e-6;  // of a beam
  const auto count = static_cast<double>(beams.count);
  for (double i = std::max(0.0, std::ceil(first - kRound)); i <= last + kRound && i < count; ++i) {
    float& range = scan.ranges_m[static_cast<std::size_t>(i)];
    range = range == Scan::kNotLooked ? static_cast<float>(range_m)
                                      : std::min(range, static_cast<float>(range_m));
  }
}

}  // namespace

Scan asStandardScan(const Beams& beams, std::span<const float> ranges_m, double stamp_s,
                    const LidarMount& mount) {
  Scan scan{stamp_s, Beams{}, {}};
  if (beams == scan.beams && mount.at == Pose{} && mount.nearest_m <= 0.0) {
    scan.ranges_m.assign(ranges_m.begin(), ranges_m.end());
    for (float& range : scan.ranges_m)
      if (!(range > 0.0F)) range = Scan::kNotLooked;
    return scan;
  }
  scan.ranges_m.assign(scan.beams.count, Scan::kNotLooked);
  constexpr double kWidest_rad = 0.2;
  const double share = mount.at.position() == Point{} ? 0.5 : 0.7;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const double range = ranges_m[i];
    if (!(range > 0.0 && range >= mount.nearest_m)) continue;
    const double bearing = beams.bearing(i);
    if (std::isinf(range)) {
      const double half = share * std::clamp(std::abs(beams.step_rad), scan.beams.step_rad, kWidest_rad);
      shorten(scan, normalizedAngle(bearing + mount.at.yaw), half, Scan::kNothing);
      continue;
    }
    const Point end = transform(mount.at, {range * std::cos(bearing), range * std::sin(bearing)});
    const double seen_from_body = std::hypot(end.x, end.y);
    // As wide as the beams lie apart, so that coarse ones leave no gaps, and wider where another place sees
    // them at a slant; at least one of ours.
    const double apart = std::abs(beams.step_rad) * range / std::max(seen_from_body, 1e-3);
    const double half = share * std::clamp(apart, scan.beams.step_rad, kWidest_rad);
    shorten(scan, std::atan2(end.y, end.x), half, seen_from_body);
  }
  return scan;
}

std::string faultOf(const Beams& beams) {
  constexpr double kMost_rad = 10.0;
  if (!(std::abs(beams.first_rad) <= kMost_rad)) return "first_rad must be a number from -10 to 10 rad";
  const double all = std::abs(beams.step_rad) * static_cast<double>(beams.count);
  if (beams.count > 0 && !(all > 0.0 && all <= kTurn_rad * 1.01))  // false for NaN
    return "step_rad must not be 0, and all beams must lie within a turn";
  return {};
}

}  // namespace underway
