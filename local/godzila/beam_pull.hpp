#pragma once

#include <span>
#include <vector>

#include "geometry/pose.hpp"
#include "local/godzila/settings.hpp"
#include "local/scan.hpp"

namespace underway {

/// What the beams pull to together in GODZILA's optimum (heading.hpp): alpha_2 of the near ones and alpha_3
/// of the far ones.
///
///   -g24 r'^-2 [(1 - rho) L(alpha_g - alpha_i) + rho L(alpha_i)] u_i   (3.15)
///    g26 r'^2  L(alpha_g - alpha_i) u_i                                (3.16)
///
/// This is most of a tick. Its loops take no branches and call nothing, so that the compiler lets a processor
/// work on several beams at once; the sums are the same on all of them.
class BeamPull {
 public:
  BeamPull(const GodzilaSettings& settings, const Beams& beams);

  /// `ranges_m` are as many as the beams; angles are in (-pi, pi], from the body's front. Allocates nothing.
  [[nodiscard]] Point of(std::span<const float> ranges_m, double goal_rad, double facing_rad) const;

 private:
  GodzilaSettings settings_;
  std::vector<double> bearings_rad_;  // in (-pi, pi]
  std::vector<double> x_;             // the beams' unit vectors
  std::vector<double> y_;
};

}  // namespace underway
