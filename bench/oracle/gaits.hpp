#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/robot.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

using GaitId = std::uint8_t;

/// Modes that are the same body and change into each other in no time and in place, like NAO's frontal and
/// lateral: to a search they are one mode that moves in all their senses.
struct Gait {
  std::vector<ModeId> modes;
  std::array<std::optional<ModeId>, 4> moving;  ///< by Sense: the mode that does it best
  std::optional<ModeId> turning;                ///< the mode that turns best; empty: none turns

  [[nodiscard]] std::optional<ModeId> mode(Sense sense) const {
    return moving[static_cast<std::size_t>(sense)];
  }
  [[nodiscard]] bool movesToAllSides() const;
};

/// A robot's gaits under a policy.
struct Gaits {
  std::vector<Gait> all;
  std::vector<GaitId> of_mode;  ///< by ModeId

  [[nodiscard]] const Gait& of(ModeId mode) const { return all[of_mode[mode]]; }
};

/// Under kPriority the best mode is the first that can, else the fastest.
[[nodiscard]] Gaits gaitsOf(const Robot& robot, Policy policy);

}  // namespace underway::bench
