#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "geometry/pose.hpp"
#include "local/scan.hpp"

namespace underway {

struct EscapeSettings {
  double duration_s = 40.0;    ///< of one random goal at most [s]
  double reached_m = 0.15;     ///< nearer than this a random goal has served [m]
  double half_width_m = 0.25;  ///< of the lane to a random goal that must be free [m]
  double reach_m = 3.0;        ///< the furthest random goal [m]
  unsigned most_repeats = 6;   ///< however often it was trapped
};

/// GODZILA's escape strategy (Brooks 2017, 3.3.3): in a trap the goal is replaced by a random one, somewhere
/// that the scan says is free, for some time; then the goal is restored. The n-th trap is answered by n
/// random goals, one after the other. Deterministic by seed; allocates nothing.
class Escape {
 public:
  Escape(const EscapeSettings& settings, std::uint64_t seed) : settings_(settings), random_(seed) {}

  /// A trap was found: begins, from a pose of dead reckoning.
  void begin(const Scan& scan, const Pose& at, double now_s);
  /// The random goal in the frame of dead reckoning; empty when there is no escape going on.
  [[nodiscard]] std::optional<Point> goal(const Scan& scan, const Pose& at, double now_s);
  void end() { left_ = 0; }

  [[nodiscard]] bool isGoingOn() const { return left_ > 0; }
  [[nodiscard]] unsigned traps() const { return traps_; }

 private:
  void pick(const Scan& scan, const Pose& at, double now_s);

  EscapeSettings settings_;
  std::mt19937_64 random_;
  unsigned traps_ = 0;
  unsigned left_ = 0;  // random goals, with this one
  Point goal_;
  double until_s_ = 0.0;
};

}  // namespace underway
