#pragma once

#include <array>
#include <chrono>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <vector>

#include "planner/plan.hpp"
#include "planner/replan.hpp"

namespace underway {

/// A goal in the robot's words.
struct NamedGoal {
  Point at;                        ///< [m]
  std::optional<double> yaw = {};  ///< [rad]; empty: any heading
  std::string mode = {};           ///< empty: the first mode
};

/// What a question asks: a plan; the same given the plan that is being followed; whether that one still
/// holds.
enum class Purpose : std::uint8_t { kPlan, kReplan, kCheck };

/// The plan that is being followed, in the robot's words: which modes its segments are in.
struct Followed {
  Executing executing;
  std::vector<std::string> mode_names;  ///< by ModeId
  double least_gain = Reluctance{}.share;
  double least_gain_s = Reluctance{}.least_s;
};

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
  std::vector<NamedGoal> other_goals = {};  ///< that would do as well
  Purpose purpose = Purpose::kPlan;
  Followed followed = {};  ///< unless only a plan is asked for
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
