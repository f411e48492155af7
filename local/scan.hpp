#pragma once

#include <algorithm>
#include <array>
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
  /// Every n-th of them, from the i-th on.
  [[nodiscard]] Beams every(std::size_t n, std::size_t i) const {
    return {i < count ? (count - i + n - 1) / n : 0, bearing(i), static_cast<double>(n) * step_rad};
  }
  bool operator==(const Beams&) const = default;
};

/// Calls `visit(i, direction)` for each beam, with its unit vector in a frame that the body frame is turned
/// in by an angle. Eight directions go on abreast, each turned by eight steps at a time: right to 1e-13, no
/// sines, and none waits for the one before it.
template <class Visit>
void forEachBeam(const Beams& beams, double turned_rad, const Visit& visit) {
  constexpr std::size_t kAbreast = 8;
  std::array<double, kAbreast> x;
  std::array<double, kAbreast> y;
  for (std::size_t k = 0; k < kAbreast; ++k) {
    x[k] = std::cos(beams.bearing(k) + turned_rad);
    y[k] = std::sin(beams.bearing(k) + turned_rad);
  }
  const double c = std::cos(kAbreast * beams.step_rad);
  const double s = std::sin(kAbreast * beams.step_rad);
  for (std::size_t first = 0; first < beams.count; first += kAbreast) {
    const std::size_t count = std::min(kAbreast, beams.count - first);
    for (std::size_t k = 0; k < count; ++k) visit(first + k, Point{x[k], y[k]});
    for (std::size_t k = 0; k < kAbreast; ++k) {
      const double before = x[k];
      x[k] = c * before - s * y[k];
      y[k] = s * before + c * y[k];
    }
  }
}

/// What a planar range sensor saw at one moment: for each beam the distance from the body frame's origin to
/// what is nearest along it [m]. kNothing where the beam met nothing in its range; kNotLooked, which is as
/// far as any, where the sensor does not look or told nothing, so that nobody knows what is there.
struct Scan {
  static constexpr float kNothing = std::numeric_limits<float>::infinity();
  static constexpr float kNotLooked = std::numeric_limits<float>::max();

  double stamp_s = 0.0;  ///< when it was taken [s]
  Beams beams;
  std::vector<float> ranges_m;  ///< as many as beams.count

  /// The least range of the beam nearest to a bearing and of its two neighbours [m]; 0 where one of them does
  /// not look.
  [[nodiscard]] float leastNear(double bearing_rad) const {
    const double beam = std::round((bearing_rad - beams.first_rad) / beams.step_rad);
    if (!(beam >= 1.0 && beam + 1.0 < static_cast<double>(beams.count))) return 0.0F;
    const auto i = static_cast<std::size_t>(beam);
    const float before = ranges_m[i - 1];
    const float at = ranges_m[i];
    const float after = ranges_m[i + 1];
    if (before == kNotLooked || at == kNotLooked || after == kNotLooked) return 0.0F;
    return std::min({before, at, after});
  }
};

}  // namespace underway
