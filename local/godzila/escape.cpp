#include "local/godzila/escape.hpp"

#include <algorithm>

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

/// The best of a few random directions by how far the robot can go in them.
void Escape::pick(const Scan& scan, const Pose& at, double now_s) {
  constexpr int kTries = 8;
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double farthest = 0.0;
  for (int i = 0; i < kTries; ++i) {
    const double bearing = scan.beams.bearing(
        static_cast<std::size_t>(share(random_) * static_cast<double>(scan.beams.count - 1)));
    const double free = freeAlong(scan, bearing, settings_.half_width_m, 5.0);
    const double range = std::min(free - 0.3, settings_.reach_m) * (0.5 + 0.5 * share(random_));
    if (range <= farthest) continue;
    farthest = range;
    goal_ = transform(at, {range * std::cos(bearing), range * std::sin(bearing)});
    break;
  }
  if (farthest == 0.0) goal_ = transform(at, {-0.3, 0.0});  // nowhere to go ahead: back, where it came from
  until_s_ = now_s + settings_.duration_s;
}

}  // namespace underway
