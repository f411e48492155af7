#include "gait/crawl/arm.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace underway::gait {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The upper arm's frame in the torso's: its x axis along the upper arm.
Matrix3d upperArm(const ArmAngles& a) {
  return (AngleAxisd(a.shoulder_pitch, Vector3d::UnitY()) * AngleAxisd(a.shoulder_roll, Vector3d::UnitZ()))
      .toRotationMatrix();
}

}  // namespace

double ArmLengths::humerus() const { return std::hypot(upper_m, offset_m); }
double ArmLengths::offsetAngle() const { return std::atan2(offset_m, upper_m); }

double ArmLengths::projected(double spread_m) const {
  const double humerus_m = humerus();
  return std::sqrt(std::max(0.0, (humerus_m - spread_m) * (humerus_m + spread_m)));
}

double ArmLengths::spreadFor(double projected_m) const {
  const double humerus_m = humerus();
  return std::sqrt(std::max(0.0, (humerus_m - projected_m) * (humerus_m + projected_m)));
}

Feasible<double> shoulderRollFor(const ArmLengths& arm, double spread_m) {
  const double humerus_m = arm.humerus();
  if (std::abs(spread_m) > humerus_m) return tl::unexpected(Infeasible{std::abs(spread_m), 0.0, humerus_m});
  return std::asin(spread_m / humerus_m) - arm.offsetAngle();
}

ArmAngles pointForearm(ArmAngles shoulder, const Vector3d& forearm, double most_bend_rad) {
  const Vector3d w = upperArm(shoulder).transpose() * forearm;
  const double off_axis = std::hypot(w.y(), w.z());
  shoulder.elbow_roll = -std::min(std::atan2(off_axis, w.x()), most_bend_rad);
  shoulder.elbow_yaw = off_axis == 0.0 ? 0.0 : std::atan2(-w.z(), -w.y());
  return shoulder;
}

ArmPlacement placementOf(const ArmLengths& arm, const ArmAngles& angles) {
  const Matrix3d upper = upperArm(angles);
  const Matrix3d elbow =
      (AngleAxisd(angles.elbow_yaw, Vector3d::UnitX()) * AngleAxisd(angles.elbow_roll, Vector3d::UnitZ()))
          .toRotationMatrix();
  return {upper * Vector3d(arm.upper_m, arm.offset_m, 0.0), upper * elbow.col(0)};
}

}  // namespace underway::gait
