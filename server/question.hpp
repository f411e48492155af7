#pragma once

#include <array>
#include <chrono>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "planner/plan.hpp"

namespace underway {

/// What a robot asks a plan server. A Request in the robot's words: it names its modes, for only the server's
/// robot file numbers them. Poses in the map frame.
struct Question {
  std::string robot;  ///< who asks; see isRobotName
  Pose start;
  std::string start_mode;  ///< empty: the first mode
  Point goal;
  std::optional<double> goal_yaw;  ///< [rad]; empty: any heading
  std::string goal_mode;           ///< empty: the first mode
  Policy policy = Policy::kPriority;
  double max_detour = 3.0;  ///< see Request
  std::chrono::milliseconds deadline{
      5000};  ///< for planning, from the request's arrival at the server; 1..600000
};

/// Tells requests apart: a client's random id and its count.
struct RequestId {
  std::array<std::uint8_t, 16> client{};
  std::uint64_t sequence = 0;
  auto operator<=>(const RequestId&) const = default;
};

/// Whether a name can be a robot's: 1..64 of A-Z a-z 0-9 _ -. It is also the DDS partition of the robot's
/// replies.
[[nodiscard]] bool isRobotName(std::string_view text);

}  // namespace underway
