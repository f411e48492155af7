#pragma once

#include <array>

#include "gait/crawl/infeasible.hpp"
#include "gait/crawl/plane.hpp"

namespace underway::gait {

/// The closed chain of the push: a robot on its toes and elbows, seen from the side, is five links from the
/// toe to the elbow, both ends fixed on the floor (Brooks 2017, 4.2.2; equations (4.8)-(4.20)).
///
/// Angles are counter-clockwise seen from the robot's right, crawling along x; lengths in metres. Functions
/// of this file are pure and may be called from any number of threads.

/// Toe to ankle, ankle to knee, knee to hip, hip to shoulder, shoulder to elbow (projected) [m].
using LinkLengths = std::array<double, 5>;

/// The three angles the push is free in [rad].
struct Triplet {
  double knee = 0.0;   ///< theta3, the thigh against the shin
  double hip = 0.0;    ///< theta4, the back against the thigh
  double alpha = 0.0;  ///< the upper arm against the floor; falls from -30 to -90 degrees in a push
  bool operator==(const Triplet&) const = default;
};

/// theta1..theta5 [rad]: the foot against the floor, then each link against the one before it.
struct ChainAngles {
  std::array<double, 5> theta{};
  [[nodiscard]] double toe() const { return theta[0]; }
  [[nodiscard]] double ankle() const { return theta[1]; }
  [[nodiscard]] double knee() const { return theta[2]; }
  [[nodiscard]] double hip() const { return theta[3]; }
  [[nodiscard]] double shoulder() const { return theta[4]; }
  /// The back against the floor.
  [[nodiscard]] double back() const { return theta[0] + theta[1] + theta[2] + theta[3]; }
};

/// Toe, ankle, knee, hip, shoulder, elbow [m], the toe at the origin.
using ChainPoints = std::array<PlanePoint, 6>;

/// Forward: where the joints are.
[[nodiscard]] ChainPoints pointsOf(const LinkLengths& lengths, const ChainAngles& angles);

/// How far the chain is from closed: the distance of its last point from the elbow's place [m].
[[nodiscard]] double closureError(const LinkLengths& lengths, const ChainAngles& angles, PlanePoint elbow);

/// The two ways to close a chain; they are one where foot and leg are stretched.
struct ChainRoots {
  ChainAngles ankle_up;    ///< theta2 = base - acos(c)
  ChainAngles ankle_down;  ///< theta2 = base + acos(c)
};

/// Inverse: both closed chains with these three angles, the toe at the origin and the elbow at `elbow`
/// (the paper's is at (d_e, 0)). Infeasible when foot and leg cannot span what is left between toe and
/// shoulder. Every number must be finite and every length positive.
[[nodiscard]] Feasible<ChainRoots> closeChain(const LinkLengths& lengths, const Triplet& triplet,
                                              PlanePoint elbow);

/// The root a robot on a floor can take: the one whose lowest joint is higher. The paper's other one has the
/// ankle below the floor.
[[nodiscard]] const ChainAngles& choose(const LinkLengths& lengths, const ChainRoots& roots);

/// Both of the above: the first root if it keeps all joints off the floor, else the one that `choose` takes.
[[nodiscard]] Feasible<ChainAngles> pushPose(const LinkLengths& lengths, const Triplet& triplet,
                                             PlanePoint elbow);

/// The distances from toe to elbow on the floor [m] at which a triplet can be taken.
struct Reach {
  double least_m = 0.0;
  double most_m = 0.0;
};
/// Infeasible when the arm is longer below the shoulder than the leg can lift it. Of the distances in front
/// of the toe; foot and leg must span at least what the arm reaches down.
[[nodiscard]] Feasible<Reach> reachOf(const LinkLengths& lengths, const Triplet& triplet);

}  // namespace underway::gait
