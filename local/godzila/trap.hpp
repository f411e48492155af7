#pragma once

#include <array>
#include <cstddef>

#include "geometry/pose.hpp"

namespace underway {

struct TrapSettings {
  double window_s = 60.0;  ///< how long it is watched [s]
  double least_m = 0.8;    ///< a net displacement below this in the window is a trap [m]
  double tick_s = 0.1;     ///< between two calls [s]
};

/// GODZILA's trap detector (Brooks 2017, 3.3.3): the velocity integrated over a sliding window. What counts
/// is the net displacement, so rocking to and fro is a trap. Allocates nothing.
class TrapDetector {
 public:
  explicit TrapDetector(const TrapSettings& settings);

  /// Tells where dead reckoning has led by now; whether this is a trap.
  [[nodiscard]] bool watch(Point at);
  /// Forgets what it saw: the window begins anew.
  void reset() { seen_ = 0; }

 private:
  static constexpr std::size_t kMost = 1024;
  TrapSettings settings_;
  std::size_t window_;  // in ticks
  std::size_t seen_ = 0;
  std::array<Point, kMost> past_{};
};

}  // namespace underway
