#pragma once

#include <span>
#include <vector>

#include "geometry/sweep.hpp"

namespace underway {

/// Points of the floor that turn together about a pivot, to be enclosed in boxes.
class TurningPoints {
 public:
  TurningPoints(std::span<const Point> points, Point pivot);

  /// The smallest box of a heading that holds all of them while they turn by any angle of a range [rad,
  /// counter-clockwise]; its frame is at the pivot.
  [[nodiscard]] Prism boxAround(Range angles_rad, double yaw, Range z) const;
  /// Of the furthest from the pivot [m].
  [[nodiscard]] double reach() const;

 private:
  struct Polar {
    double radius_m;
    double bearing_rad;
  };
  [[nodiscard]] double furthest(Range angles_rad, double direction_rad) const;

  Point pivot_;
  std::vector<Polar> points_;
};

}  // namespace underway
