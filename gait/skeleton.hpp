#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace underway::gait {

/// A ball that is part of a link's shape, in the link's frame [m]. A capsule is two, a box eight of radius 0:
/// what encloses the balls encloses the shape.
struct Ball {
  Eigen::Vector3d center;
  double radius_m = 0.0;
};

/// What a joint may do [rad, rad/s, Nm].
struct JointLimits {
  double lower_rad = 0.0;
  double upper_rad = 0.0;
  double speed_radps = 0.0;
  double torque_nm = 0.0;
};

/// One rigid link and the revolute joint that carries it, in the manner of a URDF whose frames are parallel
/// when all angles are 0: x forward, y left, z up.
struct Link {
  std::string name;
  std::string joint;       ///< the robot's own name of the joint; empty for the root
  int parent = -1;         ///< index of the link it hangs on; -1 for the root
  Eigen::Vector3d offset;  ///< of the joint, in the parent's frame [m]
  Eigen::Vector3d axis;    ///< of the joint, unit length
  JointLimits limits;
  double mass_kg = 0.0;
  Eigen::Vector3d mass_center;  ///< in the link's frame [m]
  std::vector<Ball> shape;      ///< what may touch the floor; encloses the link
  std::string turns_with;       ///< the joint whose angle this one has too: one motor for two; else empty
};

/// A robot as a tree of links; parents stand before their children, the root first.
struct Skeleton {
  std::string name;
  std::vector<Link> links;

  /// The joints with a motor of their own, in the order of the links.
  [[nodiscard]] std::vector<std::string> joints() const;
  [[nodiscard]] std::optional<std::size_t> findJoint(std::string_view joint) const;  ///< its link
  [[nodiscard]] std::optional<std::size_t> findLink(std::string_view link) const;
  [[nodiscard]] double mass() const;  ///< [kg]
};

/// Where all links are, in the root's frame.
using Placements = std::vector<Eigen::Isometry3d, Eigen::aligned_allocator<Eigen::Isometry3d>>;

/// Forward kinematics. `angles_rad` by Skeleton::joints(); throws std::invalid_argument when there are too
/// many or too few.
[[nodiscard]] Placements placementsOf(const Skeleton& skeleton, std::span<const double> angles_rad);

/// The robot's centre of mass, in the root's frame [m].
[[nodiscard]] Eigen::Vector3d massCenterOf(const Skeleton& skeleton, const Placements& placements);

/// All balls, in the root's frame.
[[nodiscard]] std::vector<Ball> ballsOf(const Skeleton& skeleton, const Placements& placements);

}  // namespace underway::gait
