#include "geometry/turning_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace underway {
namespace {

constexpr double kRevolution = 2.0 * std::numbers::pi;

/// The largest cosine of an interval's angles.
double largestCosine(double from, double to) {
  const bool holds_a_summit = std::floor(to / kRevolution) >= std::ceil(from / kRevolution);
  return holds_a_summit ? 1.0 : std::max(std::cos(from), std::cos(to));
}

}  // namespace

TurningPoints::TurningPoints(std::span<const Point> points, Point pivot) : pivot_(pivot) {
  points_.reserve(points.size());
  for (const Point& point : points)
    points_.push_back({distance(pivot, point), std::atan2(point.y - pivot.y, point.x - pivot.x)});
}

double TurningPoints::reach() const {
  double reach_m = 0.0;
  for (const Polar& point : points_) reach_m = std::max(reach_m, point.radius_m);
  return reach_m;
}

/// How far they come in a direction, from the pivot.
double TurningPoints::furthest(Range angles_rad, double direction_rad) const {
  double furthest = -std::numeric_limits<double>::infinity();
  for (const Polar& point : points_) {
    const double turned = point.bearing_rad - direction_rad;
    furthest =
        std::max(furthest, point.radius_m * largestCosine(turned + angles_rad.min, turned + angles_rad.max));
  }
  return furthest;
}

Prism TurningPoints::boxAround(Range angles_rad, double yaw, Range z) const {
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  return {{pivot_.x, pivot_.y, yaw},
          {-furthest(angles_rad, yaw + 2.0 * kQuarter), furthest(angles_rad, yaw)},
          {-furthest(angles_rad, yaw - kQuarter), furthest(angles_rad, yaw + kQuarter)},
          z};
}

}  // namespace underway
