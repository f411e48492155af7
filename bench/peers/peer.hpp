#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/robot.hpp"
#include "geometry/world.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

/// A plan's cost at a time since the run began, from the world in memory.
struct Sample {
  double time_s = 0.0;
  double cost_s = 0.0;  ///< time the plan takes
};

/// One run of one planner on one query.
struct Run {
  std::vector<Sample> progress;  ///< each better than the one before; empty: not solved
  double took_s = 0.0;
  bool was_killed = false;  ///< it went on beyond its limit and was ended
};

/// What one run is given.
struct Task {
  std::shared_ptr<const World> world;
  std::shared_ptr<const Robot> robot;
  Request request;
  double limit_s = 1.0;
  unsigned long seed = 1;
};

/// OMPL's planners, by OMPL's names.
[[nodiscard]] std::vector<std::string> peerNames();

/// Runs one of OMPL's planners as a user would write it: SE(2) times the modes, FCL's tree of the obstacles,
/// a state valid when the mode's box, grown by the margin, touches nothing and is in bounds, a motion valid
/// when states 1 cm and 2 degrees apart are. Two things are made easier for OMPL than for us: a mode moves to
/// all sides at its best speed and always turns (at the slowest turn of the other modes if it cannot); and it
/// switches on any motion that is valid in both modes, for the switch's duration, without its box or
/// displacement. The cost is the time this takes. RRTConnect starts again as often as time allows, each path
/// simplified as OMPL does.
///
/// In a process of its own, which is ended when it does not keep to its limit. Throws std::runtime_error when
/// there cannot be one.
[[nodiscard]] Run runPeer(const std::string& name, const Task& task);

}  // namespace underway::bench
