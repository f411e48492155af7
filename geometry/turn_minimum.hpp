#pragma once

#include <cmath>
#include <functional>
#include <optional>

#include "geometry/convex.hpp"
#include "geometry/motion.hpp"
#include "geometry/sweep.hpp"

namespace underway {

/// Finds the least of something over a motion's headings, by branch and bound: within half an interval no
/// corner moves further than reach times half the angle, so no distance changes by more. A motion that is not
/// a turn has one heading.
class TurnMinimum {
 public:
  TurnMinimum(const Motion& motion, double reach_m, double tolerance_m)
      : middle_(motion.from.yaw + 0.5 * sweptAngle(motion)),
        half_(0.5 * std::abs(sweptAngle(motion))),
        reach_m_(reach_m),
        tolerance_m_(tolerance_m) {}

  /// The least gap below `best_m`, told at most the tolerance too low and never too high; `best_m` when none
  /// is lower. `gap_at(yaw)` is the exact gap at a heading.
  template <class GapAt>
  [[nodiscard]] Gap leastGap(const GapAt& gap_at, double best_m) const {
    Gap best{best_m, {}};
    const double slack = half_ > 0.0 ? tolerance_m_ : 0.0;
    const auto search = [&](const auto& self, double middle, double half) -> void {
      if (best.distance_m <= 0.0) return;  // nothing is nearer than touching
      const Gap gap = gap_at(middle);
      if (gap.distance_m - slack < best.distance_m) best = {std::max(0.0, gap.distance_m - slack), gap.at};
      if (gap.distance_m - reach_m_ * half >= best.distance_m || half == 0.0) return;
      self(self, middle - 0.5 * half, 0.5 * half);
      self(self, middle + 0.5 * half, 0.5 * half);
    };
    search(search, middle_, half_);
    return best;
  }

  /// The lowest height that `height_at(yaw, moved_m)` finds with the body at a heading grown by `moved_m`; a
  /// growth below the tolerance counts as none.
  template <class HeightAt>
  [[nodiscard]] std::optional<double> lowest(const HeightAt& height_at) const {
    std::optional<double> best;
    const auto search = [&](const auto& self, double middle, double half) -> void {
      const std::optional<double> bound = height_at(middle, reach_m_ * half);
      if (!bound || (best && *bound >= *best)) return;
      if (const auto here = height_at(middle, 0.0)) best = std::min(best.value_or(*here), *here);
      if (half == 0.0 || reach_m_ * half < tolerance_m_) return;
      self(self, middle - 0.5 * half, 0.5 * half);
      self(self, middle + 0.5 * half, 0.5 * half);
    };
    search(search, middle_, half_);
    return best;
  }

 private:
  double middle_;
  double half_;
  double reach_m_;
  double tolerance_m_;
};

}  // namespace underway
