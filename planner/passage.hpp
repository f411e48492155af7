#pragma once

#include <optional>
#include <vector>

#include "planner/legs.hpp"

namespace underway {

/// A step of the way: a stop that any leg may come to and leave, or fixed motions from one pose to another (a
/// start, a crossing, a goal).
struct Option {
  Pose in;
  Pose out;
  ModeId in_mode = 0;
  ModeId out_mode = 0;
  bool is_stop = false;      ///< headings and modes are as the legs have them
  bool any_heading = false;  ///< on the way in
  double keep_m = 0.0;       ///< clearance on legs and changes here [m]
  Route motions;             ///< from in to out
  Cost cost;                 ///< of those

  [[nodiscard]] static Option stop(Point at, double keep_m);
};

/// A way from start to goal, step by step.
struct Passage {
  struct Step {
    Option option;
    const Legs* legs = nullptr;      ///< on the leg to it
    std::optional<std::size_t> way;  ///< of that leg; empty: it is where the last one was
    Stance arriving;                 ///< before any change there
    Stance leaving;                  ///< after all changes there; the same but for fixed options
  };
  std::vector<Step> steps;
  Cost cost;
  std::size_t goal = 0;  ///< which of the target's (search.hpp) it leads to
};

/// Where a stop may serve on the leg to a step: where one part of the leg needs no turn at its other end.
[[nodiscard]] std::vector<Point> stopsBetween(const std::vector<Passage::Step>& steps, std::size_t i);

/// Whether a policy counts each metre of the leg to a step, before any time.
[[nodiscard]] bool isAside(Policy policy, const Passage::Step& step);

/// The motions of a passage, chained bit for bit; empty if rounding spoils one.
[[nodiscard]] Route routeOf(const Passage& passage);

}  // namespace underway
