#pragma once

#include <array>

#include "geometry/motion.hpp"
#include "geometry/robot.hpp"

namespace underway {

/// An upright box: ranges in the plane of a frame, and heights above the map frame's origin [m].
struct Prism {
  Pose frame;  ///< of x and y, in the map frame
  Range x;
  Range y;
  Range z;  ///< absolute: what a mode sees lies in here

  /// Grown in the plane to all four sides.
  [[nodiscard]] Prism grown(double by_m) const { return {frame, x.grown(by_m), y.grown(by_m), z}; }
  /// Corners in the plane, counter-clockwise, map frame.
  [[nodiscard]] std::array<Point, 4> footprint() const;
};

/// The slab a motion's mode sees, above the map frame's origin: [floor + max(step over, 5 mm), floor +
/// height]. A switch steps over what both its modes step over.
[[nodiscard]] Range slabOf(const Robot& robot, const Motion& motion, double floor_z_m);

/// All that a translation, a switch or standing still covers: one box, a translation's widened to both sides
/// by drift times length. Of a turn: the body at the turn's beginning.
[[nodiscard]] Prism sweptBox(const Robot& robot, const Motion& motion, double floor_z_m);
/// The same with the motion's slab already at hand.
[[nodiscard]] Prism sweptBox(const Robot& robot, const Motion& motion, Range slab);

/// The turn's angle [rad], or one revolution if it is more: nothing new is covered after that.
[[nodiscard]] double sweptAngle(const Motion& motion);

/// A turn is judged on pieces: the body at `yaw` and all within `half_rad` of it lie within `reach_m *
/// half_rad` of the body at `yaw`, because no corner is further from the pivot than its reach.
[[nodiscard]] double reachOf(const BodyBox& body);

}  // namespace underway
