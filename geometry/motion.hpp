#pragma once

#include <cstdint>
#include <string_view>

#include "geometry/pose.hpp"
#include "geometry/robot.hpp"

namespace underway {

enum class MotionKind : std::uint8_t { kTranslate, kTurn, kSwitch };
/// "translate", "turn", "switch".
[[nodiscard]] std::string_view name(MotionKind kind);

/// One piece of movement in one mode. Make it with the functions below, which keep the invariants:
/// - translate: from.yaw == to.yaw, and the step lies along `sense`;
/// - turn: same position; `angle_rad` is signed and leads from from.yaw to to.yaw (mod 2 pi); 0 is standing
/// still;
/// - switch: `to` is `from` moved by the switch's displacement.
struct Motion {
  MotionKind kind = MotionKind::kTurn;
  ModeId mode = 0;                ///< the mode it starts in
  ModeId to_mode = 0;             ///< the mode it ends in; differs from `mode` for a switch only
  Sense sense = Sense::kForward;  ///< of a translation
  Pose from;                      ///< in the map frame
  Pose to;                        ///< in the map frame
  double angle_rad = 0.0;         ///< of a turn, counter-clockwise positive; may exceed pi
  bool operator==(const Motion&) const = default;
};

/// To `to`, which lies straight ahead in `sense`: the heading stays.
[[nodiscard]] Motion translate(ModeId mode, Sense sense, const Pose& from, Point to);
/// Along `sense` by a distance >= 0 [m].
[[nodiscard]] Motion translate(ModeId mode, Sense sense, const Pose& from, double distance_m);
/// About the body frame's origin, by a signed angle [rad], ending at a given heading equal to it mod 2 pi.
[[nodiscard]] Motion turn(ModeId mode, const Pose& from, double angle_rad, double to_yaw);
/// No motion at all: is the pose itself free?
[[nodiscard]] Motion stay(ModeId mode, const Pose& at);
[[nodiscard]] Motion switchModes(const Switch& change, const Pose& from);

/// Distance / speed, |angle| / turn speed, or the switch's duration [s]. Infinite if the mode lacks the
/// sense.
[[nodiscard]] double duration(const Robot& robot, const Motion& motion);
/// Length of a translation, else 0 [m].
[[nodiscard]] double length(const Motion& motion);

}  // namespace underway
