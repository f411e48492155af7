#pragma once

#include <array>

#include "gait/crawl/infeasible.hpp"
#include "gait/crawl/plane.hpp"

namespace underway::gait {

/// An open chain of the crawl: chest and knees on the floor, an arm or a lower leg is two links that move
/// alone (Brooks 2017, 4.2.1; equations (4.1)-(4.7)). In the sagittal plane, angles counter-clockwise. Pure
/// functions.

struct Limb {
  PlanePoint root;            ///< the shoulder, or the knee [m]
  std::array<double, 2> m{};  ///< upper arm and forearm, or shin and foot [m]
};

struct LimbAngles {
  double root = 0.0;   ///< theta1: the first link against the floor [rad]
  double joint = 0.0;  ///< theta2: the second against the first [rad]
};

/// Forward (4.1), (4.2): the joint between the links, and the end.
struct LimbPoints {
  PlanePoint joint;
  PlanePoint end;
};
[[nodiscard]] LimbPoints pointsOf(const Limb& limb, const LimbAngles& angles);

/// Inverse (4.3)-(4.7): the two ways to bring the end to a point; they are one when the limb is stretched.
struct LimbRoots {
  LimbAngles left;   ///< theta2 >= 0: the second link turned counter-clockwise
  LimbAngles right;  ///< theta2 <= 0
};
/// Infeasible when the point is out of reach.
[[nodiscard]] Feasible<LimbRoots> reach(const Limb& limb, PlanePoint end);

/// The root that keeps the joint higher above the floor: no part of the limb may go into it.
[[nodiscard]] const LimbAngles& choose(const Limb& limb, const LimbRoots& roots);

}  // namespace underway::gait
