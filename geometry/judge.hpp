#pragma once

#include "geometry/fcl_scene.hpp"
#include "geometry/motion.hpp"
#include "geometry/world.hpp"

namespace underway {

/// The second opinion on a motion: FCL's booleans on the source shapes. Shares neither the layers nor the
/// distances of Checker, so that an error there is caught before a plan is sent. Thread safety: const members
/// may be called from any number of threads.
class Judge {
 public:
  /// World, robot and scene must outlive the judge.
  Judge(const World& world, const Robot& robot, const FclScene& scene)
      : world_(world), robot_(robot), scene_(scene) {}

  /// Whether nothing comes nearer than `clearance_m` (Euclidean, in the plane) over the whole motion. Turns
  /// are enclosed in boxes, by halves where one is not enough, and judged to 0.1 mm, all else to 1 um.
  [[nodiscard]] bool isClear(const Motion& motion, double clearance_m) const;

 private:
  const World& world_;
  const Robot& robot_;
  const FclScene& scene_;
};

}  // namespace underway
