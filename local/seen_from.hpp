#pragma once

#include <cmath>

#include "geometry/pose.hpp"

namespace underway {

/// Points of the map frame as they are seen from a pose: in its body frame. For many points from one pose,
/// whose sines are taken once.
class SeenFrom {
 public:
  explicit SeenFrom(const Pose& pose)
      : at_(pose.position()), cos_(std::cos(pose.yaw)), sin_(std::sin(pose.yaw)) {}

  [[nodiscard]] Point operator()(Point p) const {
    const double dx = p.x - at_.x;
    const double dy = p.y - at_.y;
    return {cos_ * dx + sin_ * dy, cos_ * dy - sin_ * dx};
  }

 private:
  Point at_;
  double cos_;
  double sin_;
};

}  // namespace underway
