#pragma once

#include "geometry/map.hpp"
#include "planner/plan.hpp"

namespace underway::bench {

/// What a map's query asks of a robot. Modes the robot does not have are its first.
[[nodiscard]] inline Request requestOf(const Query& query, const Robot& robot) {
  Request request;
  request.start = query.start;
  request.start_mode = robot.findMode(query.start_mode).value_or(0);
  request.goal = query.goal;
  request.goal_yaw = query.goal_yaw;
  request.goal_mode = robot.findMode(query.goal_mode).value_or(0);
  return request;
}

}  // namespace underway::bench
