#include "local/godzila/trap.hpp"

#include <algorithm>
#include <cmath>

namespace underway {

TrapDetector::TrapDetector(const TrapSettings& settings)
    : settings_(settings),
      window_(static_cast<std::size_t>(std::clamp(std::round(settings.window_s / settings.tick_s), 1.0,
                                                  static_cast<double>(kMost - 1)))) {}

bool TrapDetector::watch(Point at) {
  past_[seen_ % window_] = at;
  ++seen_;
  return seen_ >= window_ && distance(past_[seen_ % window_], at) < settings_.least_m;
}

}  // namespace underway
