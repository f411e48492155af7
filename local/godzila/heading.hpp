#pragma once

#include "geometry/pose.hpp"
#include "local/godzila/beam_pull.hpp"
#include "local/godzila/settings.hpp"
#include "local/scan.hpp"

namespace underway {

/// A goal as GODZILA sees it, from the body frame.
struct Bearing {
  double range_m = 0.0;      ///< r_g
  double bearing_rad = 0.0;  ///< alpha_g, counter-clockwise from the body's front
};
/// Where a point of the map frame is, seen from a pose.
[[nodiscard]] Bearing bearingOf(Point goal, const Pose& from);

/// The functions of range that the thesis leaves to the designer. Near the clearance threshold costs rise
/// steeply: r' = r - clr exp(-r), kept above 0.02 m: a beam inside the threshold weighs much, not infinitely.
inline constexpr double kLeastShortened_m = 0.02;
[[nodiscard]] double shortened(double range_m, double clearance_threshold_m);

/// GODZILA's optimisation (Brooks 2017, (3.6)-(3.17)) by its closed form.
///
///   J1 = f11 g11(r_g) |u - u_g|^2 / 2                 towards the goal               (3.7)
///   J2 = g24 sum_I1 g21(r_i) [g22 + g23] (4 - |u - u_i|^2) / 2   away from the near  (3.9)
///      - g26 sum_I2 f21(r_i) g25         (4 - |u - u_i|^2) / 2   towards the far     (3.10)
///   J3 = f31 |u - u_r|^2 / 2                          no sudden turns                (3.11)
///
/// with u the unit vector of the heading looked for. All four are linear in u, so the best heading is that of
/// alpha = alpha_1 + alpha_2 + alpha_3 + alpha_4. Beams are summed, not averaged. g11(r) = r^-2, g21 = r'^-2,
/// f21 = r'^2, L(a) = 1 / (a^2 + eps^2), g22 = (1 - rho) L(alpha_g - alpha_i), g23 = rho L(alpha_i), g25 =
/// L(alpha_g - alpha_i).
///
/// `facing_rad` is alpha_r: 0 for a robot that walks ahead, the direction of the sense for one that moves
/// sideways. Bearings count from the body's front, those of g23 from `facing_rad`.
class HeadingOptimum {
 public:
  HeadingOptimum(const GodzilaSettings& settings, const Beams& beams);

  struct Result {
    Point alpha;               ///< (3.13), in the body frame
    double heading_rad = 0.0;  ///< (3.12), from the body's front; `facing_rad` if alpha is 0
    double nearest_m = 0.0;    ///< min R
    double nearest_rad = 0.0;  ///< its bearing
  };
  /// Bounded time, allocates nothing. `scan` has the beams this was made for.
  [[nodiscard]] Result of(const Scan& scan, const Bearing& goal, double facing_rad = 0.0) const;

 private:
  GodzilaSettings settings_;
  Beams beams_;
  BeamPull pull_;
};

}  // namespace underway
