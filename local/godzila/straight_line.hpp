#pragma once

#include <optional>

#include "local/godzila/heading.hpp"
#include "local/scan.hpp"

namespace underway {

struct StraightLineSettings {
  double half_width_m = 0.27;  ///< of the lane that must be free: half the body's width and some [m]
  double expected_mps = 0.05;  ///< how fast the goal is expected to come nearer; T_f = range / this [m/s]
  double least_ahead_m = 0.3;  ///< the intermediate goal is at least this far ahead [m]
};

/// Whether a lane from the robot to a goal is free, as far as the scan can tell: no beam ends in it.
[[nodiscard]] bool isLaneFree(const Scan& scan, const Bearing& goal, double half_width_m);
/// How far a lane in a direction is free, up to `most_m` [m].
[[nodiscard]] double freeAlong(const Scan& scan, double bearing_rad, double half_width_m, double most_m);

/// GODZILA's straight-line planner (Brooks 2017, 3.3.2): while the straight line to the goal is free, the
/// goal is taken for an intermediate one on the line, (1 - lambda) x_r + lambda x_g (3.19), whose lambda
/// grows from 0 to 1 in T_f. Being near it pulls more than what stands beside the line repels. After T_f it
/// begins anew.
class StraightLine {
 public:
  explicit StraightLine(const StraightLineSettings& settings) : settings_(settings) {}

  /// The intermediate goal at a time [s]; empty while the line is not free.
  [[nodiscard]] std::optional<Bearing> intermediate(const Scan& scan, const Bearing& goal, double now_s);
  void reset() { begun_s_.reset(); }

 private:
  StraightLineSettings settings_;
  std::optional<double> begun_s_;
  double allowed_s_ = 0.0;  // T_f
};

}  // namespace underway
