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

/// Calls `visit(i, direction)` for each beam, with its unit vector in a frame that the body frame is turned
/// in by an angle. Each direction is the last one turned by a step: right to 1e-12, and no sines.
template <class Visit>
void forEachBeam(const Beams& beams, double turned_rad, const Visit& visit) {
  const double c = std::cos(beams.step_rad);
  const double s = std::sin(beams.step_rad);
  Point direction{std::cos(beams.first_rad + turned_rad), std::sin(beams.first_rad + turned_rad)};
  for (std::size_t i = 0; i < beams.count; ++i) {
    visit(i, direction);
    direction = {c * direction.x - s * direction.y, s * direction.x + c * direction.y};
  }
}

/// What a planar range sensor saw at one moment: for each beam the distance from the body frame's origin to
/// what is nearest along it [m]. kNothing where the beam met nothing in its range.
struct Scan {
  static constexpr float kNothing = std::numeric_limits<float>::infinity();

  double stamp_s = 0.0;  ///< when it was taken [s]
  Beams beams;
  std::vector<float> ranges_m;  ///< as many as beams.count
};

}  // namespace underway
