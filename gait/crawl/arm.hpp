#pragma once

#include <Eigen/Core>

#include "gait/crawl/infeasible.hpp"

namespace underway::gait {

/// The arm of the crawl: a shoulder that pitches and rolls, an elbow that yaws about the upper arm and rolls
/// (Brooks 2017, 4.2.3, corrected; Brooks 2015, section IV).
///
/// Everything here is told for the left arm, in the torso's frame (x forward, y left, z up) with the shoulder
/// at the origin; JointMap (crawler.hpp) mirrors it. Pure functions.

struct ArmLengths {
  double upper_m = 0.105;   ///< along the upper arm, to the elbow
  double offset_m = 0.015;  ///< of the elbow, square to it, outwards
  /// Shoulder to elbow, in a straight line [m].
  [[nodiscard]] double humerus() const;
  /// The angle between that line and the upper arm's axis [rad].
  [[nodiscard]] double offsetAngle() const;
  /// Seen from the side, when the elbow is `spread_m` outside of the shoulder: l5 of the chain [m].
  [[nodiscard]] double projected(double spread_m) const;
  /// The spread at which the humerus looks that long from the side. 0 if it is longer than it can be.
  [[nodiscard]] double spreadFor(double projected_m) const;
};

/// Joint angles of NAO's left arm [rad].
struct ArmAngles {
  double shoulder_pitch = 0.0;
  double shoulder_roll = 0.0;  ///< outwards positive
  double elbow_yaw = 0.0;
  double elbow_roll = 0.0;  ///< bent is negative
  bool operator==(const ArmAngles&) const = default;
};

/// ShoulderRoll that brings the elbow `spread_m` outside of the shoulder: asin(d / l_h) less the offset's
/// angle (4.21). Infeasible when the spread is wider than the humerus is long.
[[nodiscard]] Feasible<double> shoulderRollFor(const ArmLengths& arm, double spread_m);

/// ElbowYaw and ElbowRoll that point the forearm along a unit vector, with the shoulder where it is (4.22, in
/// the order that closes). The elbow bends by no more than `most_bend_rad`; what is missing leaves the
/// forearm pointing between the upper arm and where it should, in the plane of both. A straight arm keeps yaw
/// 0.
[[nodiscard]] ArmAngles pointForearm(ArmAngles shoulder, const Eigen::Vector3d& forearm,
                                     double most_bend_rad);

/// Forward: the elbow [m] and the forearm's direction.
struct ArmPlacement {
  Eigen::Vector3d elbow;
  Eigen::Vector3d forearm;
};
[[nodiscard]] ArmPlacement placementOf(const ArmLengths& arm, const ArmAngles& angles);

}  // namespace underway::gait
