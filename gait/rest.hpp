#pragma once

#include <Eigen/Core>
#include <vector>

#include "gait/joint_table.hpp"
#include "gait/skeleton.hpp"

namespace underway::gait {

/// How a robot comes to lie on a level floor: the balls of its shape and gravity decide, nothing else. It
/// tips about what it stands on until its centre of mass is above its support; rolling to a side is left out,
/// so this is exact for motions that are alike on both sides, and near for those that almost are.
///
/// World frame: x the way the robot goes, y left, z up, the floor at z = 0.

/// A ball on the floor.
struct Contact {
  std::size_t link = 0;      ///< index into Skeleton::links
  Eigen::Vector3d on_link;   ///< the touching point, in the link's frame [m]
  Eigen::Vector3d on_floor;  ///< the same in the world [m]
};

/// A robot at rest.
struct Rest {
  double pitch_rad = 0.0;  ///< of the root: 0 upright, pi/2 face down
  Eigen::Vector3d root;    ///< the root's origin in the world [m]
  Eigen::Vector3d mass_center;
  std::vector<Contact> contacts;
  /// How far inside the support the centre of mass is, over the floor: the distance to the nearest border of
  /// the contacts' hull [m]. Negative outside, which a robot at rest is not but for rounding.
  double margin_m = 0.0;
  Eigen::Vector3d low;   ///< corner of the box around all balls [m]
  Eigen::Vector3d high;  ///< the opposite one

  /// From the root's frame to the world.
  [[nodiscard]] Eigen::Isometry3d placement() const;
};

/// The rest that a robot with these joint angles tips into from a pitch, its root above x = 0. `angles_rad`
/// by Skeleton::joints(). Throws std::invalid_argument when the skeleton has no shape.
[[nodiscard]] Rest settle(const Skeleton& skeleton, const std::vector<double>& angles_rad, double pitch_rad);

/// A robot at rest at each row of a motion that is slow enough for gravity to rule. Over the floor it moves
/// so that what bears the greater part of its weight, ahead or behind, does not slide. The first row's root
/// is above x = 0. Throws std::invalid_argument when the table lacks a joint of the skeleton.
[[nodiscard]] std::vector<Rest> settleAll(const Skeleton& skeleton, const JointTable& table,
                                          double pitch_rad);

}  // namespace underway::gait
