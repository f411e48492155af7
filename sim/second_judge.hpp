#pragma once

#include <memory>

#include "geometry/fcl_scene.hpp"
#include "geometry/motion.hpp"
#include "geometry/world.hpp"

namespace underway::sim {

/// A second opinion on what the simulated robot touches, beside geometry's checker, which the planner uses
/// too. The body is a box in space, at poses a millimetre apart along each motion, and FCL's booleans tell
/// whether it meets the source shapes. Shares nothing with the checker: no layers, no sweeps, no arcs. Only
/// what is near is looked at. Allocates; thread safety: const members may be called from any number of
/// threads.
class SecondJudge {
 public:
  static constexpr double kStep_m = 0.001;     ///< of a corner, between two poses [m]
  static constexpr double kTouching_m = 1e-5;  ///< nearer to contact than this, judges may disagree [m]

  SecondJudge(std::shared_ptr<const World> world, std::shared_ptr<const Robot> robot);

  /// Whether the body meets an obstacle, or leaves the bounds, on its way; grown to all sides, or shrunk if
  /// negative [m].
  [[nodiscard]] bool touches(const Motion& motion, double grown_m = 0.0) const;
  /// Whether another judge's word on a motion is wrong by more than touching: a free one whose body still
  /// meets something when it is shrunk, or a blocked one whose body, grown by what lies between two poses and
  /// by the mode's drift, meets nothing.
  [[nodiscard]] bool disputes(const Motion& motion, bool is_free) const;

 private:
  [[nodiscard]] bool isOutside(const Prism& body) const;

  std::shared_ptr<const World> world_;
  std::shared_ptr<const Robot> robot_;
  FclScene scene_;
};

}  // namespace underway::sim
