#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/error.hpp"
#include "geometry/pose.hpp"

namespace underway {

/// A direction a mode may translate in, along its body's axes.
enum class Sense : std::uint8_t { kForward, kBackward, kLeft, kRight };
inline constexpr std::array kSenses{Sense::kForward, Sense::kBackward, Sense::kLeft, Sense::kRight};

/// "forward", "backward", "left", "right".
[[nodiscard]] std::string_view name(Sense sense);
/// The direction of a sense in the body frame, counter-clockwise from the front: 0, pi, pi/2, -pi/2 [rad].
[[nodiscard]] double angleOf(Sense sense);
[[nodiscard]] Sense opposite(Sense sense);

/// Index into Robot::modes, which is in order of priority.
using ModeId = std::uint8_t;
/// As many modes as the priority cost can rank (planner/cost.hpp).
inline constexpr std::size_t kMaxModes = 5;

/// One way to move.
struct Mode {
  std::string name;
  BodyBox body_m;                     ///< in the mode's body frame
  std::array<double, 4> speed_mps{};  ///< by Sense; 0: the mode does not move in that sense
  double turn_speed_radps = 0.0;      ///< 0: the mode cannot turn
  double drift_m_per_m = 0.0;         ///< widens a translation's sweep to both sides, per metre travelled
  double step_over_m = 0.0;           ///< what is lower does not block the mode

  [[nodiscard]] double speed(Sense sense) const { return speed_mps[static_cast<std::size_t>(sense)]; }
  [[nodiscard]] bool canMove(Sense sense) const { return speed(sense) > 0.0; }
  [[nodiscard]] bool canTurn() const { return turn_speed_radps > 0.0; }
  bool operator==(const Mode&) const = default;
};

/// The change from one mode to another.
struct Switch {
  ModeId from = 0;
  ModeId to = 0;
  double duration_s = 0.0;
  Pose displacement;  ///< of the pose, given in the old body frame
  BodyBox body_m;     ///< covers the whole motion, in the old body frame
  bool operator==(const Switch&) const = default;
};

/// A planar lidar: sees what crosses its plane.
struct LidarSense {
  double height_m = 0.0;  ///< of the plane above the floor [m]
  bool operator==(const LidarSense&) const = default;
};
/// A depth camera that looks ahead: sees all heights.
struct DepthSense {
  double field_rad = 0.0;   ///< how wide it sees, half of it to either side [rad]
  double farthest_m = 0.0;  ///< [m]
  bool operator==(const DepthSense&) const = default;
};
/// What a robot sees the world with. No plan depends on it; what executes a plan does.
struct SensesOfRobot {
  std::optional<LidarSense> waist;  ///< sees while standing only
  std::optional<LidarSense> head;   ///< sees while lying only
  std::optional<DepthSense> depth;  ///< sees while standing only
  bool operator==(const SensesOfRobot&) const = default;
};

/// What a robot file says, checked: names unique, sizes and speeds sound, switches between different known
/// modes.
struct Robot {
  std::string name;
  double margin_m = 0.0;    ///< kept from every obstacle in the plane
  std::vector<Mode> modes;  ///< in order of priority; the first is the standing mode
  std::vector<Switch> switches;
  SensesOfRobot senses;

  [[nodiscard]] std::optional<ModeId> findMode(std::string_view mode_name) const;
  [[nodiscard]] const Switch* findSwitch(ModeId from, ModeId to) const;
  bool operator==(const Robot&) const = default;
};

/// The robot itself if it is sound, else kInvalidRobot with a sentence. A switch whose body was not given
/// (all zero) gets the hull of both modes' bodies.
[[nodiscard]] Expected<Robot> checkedRobot(Robot robot);

/// 16 hex digits over everything a plan depends on.
[[nodiscard]] std::string hashOf(const Robot& robot);

}  // namespace underway
