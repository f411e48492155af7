#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/pose.hpp"

namespace underway {

/// Where a planar range sensor looks, in the mode's body frame: beam i at first_rad + i * step_rad.
struct Beams {
  std::size_t count = 683;
  double first_rad = -2.0 * std::numbers::pi / 3.0;                    ///< [rad]
  double step_rad = 2.0 * std::numbers::pi / 3.0 * 2.0 / (683 - 1.0);  ///< [rad]

  [[nodiscard]] double bearing(std::size_t i) const { return first_rad + static_cast<double>(i) * step_rad; }
  bool operator==(const Beams&) const = default;
};

/// The directions of beams, worked out once: unit vectors, to be turned to wherever the first beam looks.
class BeamDirections {
 public:
  explicit BeamDirections(const Beams& beams) {
    for (std::size_t i = 0; i < beams.count; ++i)
      from_first_.push_back({std::cos(static_cast<double>(i) * beams.step_rad),
                             std::sin(static_cast<double>(i) * beams.step_rad)});
  }
  [[nodiscard]] std::size_t count() const { return from_first_.size(); }
  /// Beam i's direction when the first beam looks along a unit vector.
  [[nodiscard]] Point direction(std::size_t i, Point first) const {
    const Point d = from_first_[i];
    return {first.x * d.x - first.y * d.y, first.y * d.x + first.x * d.y};
  }

 private:
  std::vector<Point> from_first_;
};

/// What a planar range sensor saw at one moment: for each beam the distance from the body frame's origin to
/// what is nearest along it [m]. kNothing where the beam met nothing in its range.
struct Scan {
  static constexpr float kNothing = std::numeric_limits<float>::infinity();

  double stamp_s = 0.0;  ///< when it was taken [s]
  Beams beams;
  std::vector<float> ranges_m;  ///< as many as beams.count
};

}  // namespace underway
