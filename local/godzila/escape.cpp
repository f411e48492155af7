#include "local/godzila/escape.hpp"

#include <algorithm>
#include <cmath>

#include "local/godzila/straight_line.hpp"

namespace underway {

void Escape::begin(const Scan& scan, const Pose& at, double now_s) {
  ++traps_;
  left_ = std::min(traps_, settings_.most_repeats);
  pick(scan, at, now_s);
}

std::optional<Point> Escape::goal(const Scan& scan, const Pose& at, double now_s) {
  if (left_ == 0) return std::nullopt;
  if (now_s < until_s_ && distance(at.position(), goal_) >= settings_.reached_m) return goal_;
  --left_;
  if (left_ == 0) return std::nullopt;
  pick(scan, at, now_s);
  return goal_;
}

/// The first of a few random directions in which the robot can go some way; back, where it came from, if
/// there is none.
void Escape::pick(const Scan& scan, const Pose& at, double now_s) {
  constexpr int kTries = 16;
  constexpr double kFarthest_m = 5.0;
  constexpr double kBefore_m = 0.3;  // what ends the lane
  std::uniform_real_distribution<double> share(0.0, 1.0);
  goal_ = transform(at, {-kBefore_m, 0.0});
  until_s_ = now_s + settings_.duration_s;
  for (int i = 0; i < kTries; ++i) {
    const auto beam = static_cast<std::size_t>(share(random_) * static_cast<double>(scan.beams.count - 1));
    const double bearing = scan.beams.bearing(beam);
    const double free = freeAlong(scan, bearing, settings_.half_width_m, kFarthest_m);
    const double range = std::min(free - kBefore_m, settings_.reach_m) * (0.5 + 0.5 * share(random_));
    if (range < 2.0 * settings_.reached_m) continue;
    goal_ = transform(at, {range * std::cos(bearing), range * std::sin(bearing)});
    return;
  }
}

}  // namespace underway
