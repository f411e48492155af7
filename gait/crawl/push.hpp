#pragma once

#include <array>

#include "gait/crawl/chain.hpp"

namespace underway::gait {

/// c0 + c1 s + c2 s^2 + c3 s^3 over the push's phase s in [0, 1] [rad].
struct Cubic {
  std::array<double, 4> c{};
  [[nodiscard]] double at(double s) const { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }
  /// Its derivative by s [rad per push].
  [[nodiscard]] double rate(double s) const { return c[1] + s * (2.0 * c[2] + s * 3.0 * c[3]); }
  bool operator==(const Cubic&) const = default;
};

/// The cubic with these values at the ends and these derivatives by s there.
[[nodiscard]] Cubic cubicThrough(double from, double to, double from_rate, double to_rate);
/// The straight line.
[[nodiscard]] Cubic line(double from, double to);

/// What a push is: the three free angles over its phase (Brooks 2017, 6.1.3).
struct PushShape {
  Cubic knee;   ///< theta3
  Cubic hip;    ///< theta4
  Cubic alpha;  ///< falls
  [[nodiscard]] Triplet at(double s) const { return {knee.at(s), hip.at(s), alpha.at(s)}; }
  bool operator==(const PushShape&) const = default;
};

/// Table 8: theta3 16.5, theta4 27.5, alpha from -30 to -90 degrees.
[[nodiscard]] PushShape nominalPush();
/// Table 9, its alpha starting at -0.52360 where a sign is missing in print.
[[nodiscard]] PushShape thesisOptimum();
/// Found in physics itself: 500 pushes of 2 s in MuJoCo, of the paper's weights, on two floors (friction 0.49
/// and 0.91), with the robot's advance, highest point, heading and saturation weighed in; searchDescent from
/// the library's 'fast', ends free.
[[nodiscard]] PushShape physicsOptimum();

}  // namespace underway::gait
