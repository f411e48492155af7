#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/local_no_way.hpp"
#include "local/mission.hpp"
#include "planner/planner.hpp"
#include "sim/robot.hpp"

namespace underway::bench {

/// What ids of obstacles begin with that are in the true world and not in the map.
inline constexpr std::string_view kUnmapped = "unmapped";

/// A mission to be driven: the map that the planner has, the world as it is, and what is asked for.
struct Course {
  std::string name;
  std::shared_ptr<const World> map;
  std::shared_ptr<const World> truth;  ///< with what is unmapped
  Request request;
};

struct LoopRun {
  Mission::Outcome outcome = Mission::Outcome::kUnderway;
  bool has_arrived = false;  ///< in truth, within 0.05 m and 5 degrees, in the goal's mode
  /// Of one that said that there is no way: how sure that is, in the true world from where it truly stands.
  std::optional<NoWay> no_way;
  bool has_collided = false;  ///< by either judge
  bool is_disputed = false;   ///< the judges of the simulated robot disagree
  std::string why;
  double off_m = 0.0;  ///< from the goal, in truth
  double off_rad = 0.0;
  double time_s = 0.0;  ///< simulated
  int plans = 0;
};

/// Whether a pose in a mode is the goal asked for, within 0.05 m and 5 degrees.
[[nodiscard]] bool isAtGoal(const Request& request, const Pose& pose, ModeId mode);

using WatchLoop = std::function<void(const sim::SimulatedRobot&, const Mission&, const Tick&)>;

/// Drives a course: simulated robot, mission, and a planner in this process, whose world is set to what the
/// robot knows before each plan, which may take so long: as long as a follower gives a server. Deterministic
/// by seed, but for plans that take as long as that.
[[nodiscard]] LoopRun driveCourse(const Course& course, Planner& planner,
                                  const std::shared_ptr<const Robot>& robot, const ExecutorSettings& settings,
                                  const sim::Flaws& flaws, std::uint64_t seed, const WatchLoop& watch = {},
                                  std::chrono::seconds planning = std::chrono::seconds(5));

}  // namespace underway::bench
