#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/passage.hpp"

namespace underway {

/// Whether a leg from one option to another is free: checked when first asked, and once for all ways that
/// cover the same ground. Legs and options must outlive it.
class LegSweeps {
 public:
  LegSweeps(const Legs& legs, const Option& from, const Option& to) : legs_(legs), from_(from), to_(to) {}

  [[nodiscard]] bool isFree(std::size_t way) {
    char& known = known_[legs_.sameSweep(way)];
    if (known == 0) known = isFreeBy(way) ? 1 : -1;
    return known > 0;
  }

 private:
  [[nodiscard]] bool isFreeBy(std::size_t way) const {
    const Point from = from_.out.position();
    const Point to = to_.in.position();
    const Stance stance = legs_.stanceOn(std::atan2(to.y - from.y, to.x - from.x), way);
    return legs_.isLegFree(legs_.ways()[way], from, to, stance.yaw, std::min(from_.keep_m, to_.keep_m));
  }

  const Legs& legs_;
  const Option& from_;
  const Option& to_;
  std::array<char, Legs::kMostWays> known_{};  // by way; 0: not known
};

}  // namespace underway
