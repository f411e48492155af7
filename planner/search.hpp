#pragma once

#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/cost.hpp"
#include "planner/interrupt.hpp"
#include "planner/roadmap.hpp"

namespace underway {

/// Remembers which unchecked edges are free, over all searches on one roadmap. For one thread.
class EdgeChecks {
 public:
  EdgeChecks(const Roadmap& roadmap, const Checker& checker) : roadmap_(roadmap), checker_(checker) {}

  /// Whether an edge is free with `at_least_m` around it (roadmap.hpp: isFree).
  [[nodiscard]] bool isFree(Roadmap::NodeId from, const Roadmap::Edge& edge, double at_least_m);

 private:
  const Roadmap& roadmap_;
  const Checker& checker_;
  /// What is free with a clearance is free with less, what is blocked is blocked with more.
  struct Known {
    double free_at_m = -1.0;
    double blocked_at_m = std::numeric_limits<double>::infinity();
  };
  std::unordered_map<const Roadmap::Edge*, Known> known_;
};

/// What a search is to find.
struct Target {
  Roadmap::NodeId start = 0;
  Roadmap::PlaceId goal_place = 0;
  std::optional<Roadmap::NodeId> goal_node;  ///< empty: any heading of the place
  Policy policy = Policy::kPriority;         ///< kSafest is searched as kFastest with `at_least_m`
  double at_least_m = 0.0;                   ///< clearance kept beyond the margin [m]
};

/// The motions of the cheapest route, by A*; empty when there is none or it was interrupted. Edges that are
/// not checked yet are checked when they come up first in the queue, so that few need to be.
[[nodiscard]] std::optional<std::vector<Motion>> search(const Roadmap& roadmap, const Robot& robot,
                                                        EdgeChecks& checks, const Target& target,
                                                        Interrupt& interrupt);

/// A lower bound of the time from (position, mode) to the goal, consistent on every edge: the straight way at
/// the robot's highest speed, and the switches to the goal's mode as far as they take longer than they move
/// the robot.
class TimeBound {
 public:
  TimeBound(const Robot& robot, Point goal, ModeId goal_mode);
  [[nodiscard]] std::uint64_t us(Point from, ModeId mode) const;

 private:
  Point goal_;
  double fastest_mps_;
  std::vector<double> switching_s_;  // by mode; infinite where the goal's mode cannot be reached
};

}  // namespace underway
