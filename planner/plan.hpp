#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/checker.hpp"
#include "geometry/motion.hpp"

namespace underway {

/// What 'best' means.
enum class Policy : std::uint8_t {
  kPriority,  ///< least (distance in the last mode, ..., distance in the second mode, time): the OBB paper's
  kFastest,   ///< least time
  kSafest,    ///< largest least clearance up to kEnoughClearance_m, then least time
};
[[nodiscard]] std::string_view name(Policy policy);
[[nodiscard]] std::optional<Policy> findPolicy(std::string_view name);

/// More clearance than this is no safer [m].
inline constexpr double kEnoughClearance_m = 0.10;
/// Clearances are told up to this [m].
inline constexpr double kClearanceCap_m = 1.0;

/// One motion of a plan, with what is known about it.
struct Segment {
  Motion motion;
  double duration_s = 0.0;
  Closeness closeness;
};

/// Where to go, in the map frame.
struct Goal {
  Point at;                        ///< [m]
  std::optional<double> yaw = {};  ///< [rad]; empty: any heading
  ModeId mode = 0;
  bool operator==(const Goal&) const = default;
};

/// A request has no more goals than this.
inline constexpr std::size_t kMostGoals = 64;

/// What a plan is asked for. Poses in the map frame.
struct Request {
  Pose start;
  ModeId start_mode = 0;
  Point goal;
  std::optional<double> goal_yaw;  ///< [rad]; empty: any heading
  ModeId goal_mode = 0;
  Policy policy = Policy::kPriority;
  double max_detour = 3.0;  ///< kPriority takes the fastest plan when its own takes this many times as long
  /// Goals that would do as well: the plan leads to the one that is best to reach by the policy.
  std::vector<Goal> other_goals = {};
};

/// All goals of a request, `goal` first.
[[nodiscard]] std::vector<Goal> goalsOf(const Request& request);
/// The same request with other goals; at least one.
[[nodiscard]] Request withGoals(Request request, const std::vector<Goal>& goals);

/// How the answer came about.
struct PlanStats {
  std::uint64_t nodes = 0;    ///< of the roadmap
  std::uint64_t edges = 0;    ///< directed
  std::uint32_t batches = 0;  ///< of growth; with map, robot, settings and seed it fixes the roadmap
  double build_ms = 0.0;
  double query_us = 0.0;
  double certify_us = 0.0;
};

/// Segments from start to goal. Each starts where the last one ended, bit for bit; every one is certified
/// free.
struct Plan {
  std::vector<Segment> segments;
  double total_time_s = 0.0;  ///< sum of the durations
  double length_m = 0.0;      ///< sum of the translated lengths
  Pose goal;                  ///< where it ends, in the goal's mode
  PlanStats stats;
  std::uint64_t revision = 0;    ///< of the world it was made in
  std::string world_hash = {};   ///< of that world
  std::uint32_t goal_index = 0;  ///< of the goal it leads to, in goalsOf(request)
};

/// Durations and lengths summed over the segments.
[[nodiscard]] Plan timedPlan(std::vector<Segment> segments, const Pose& start);

/// The smallest clearance of all segments, kEnoughClearance_m at most [m].
[[nodiscard]] double leastClearance(const Plan& plan);

}  // namespace underway
