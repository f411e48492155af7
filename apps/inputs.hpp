#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "geometry/map.hpp"
#include "planner/plan_document.hpp"
#include "planner/replan.hpp"

namespace underway {

/// A map and a robot that have been read, to be shared between planner, checker and picture.
struct Site {
  std::shared_ptr<const World> world;
  std::shared_ptr<const Robot> robot;
  std::vector<Query> queries;  ///< that the map brings along
};

/// Errors: kInvalidMap or kInvalidRobot, one sentence; kInvalidRequest when no map was named.
[[nodiscard]] Expected<Site> readSite(const MapArguments& map, const std::string& robot);

/// The file a --robot means: itself if there is such a file, else robots/NAME.yaml of the source tree, of the
/// installation, or beside the program, in this order. Errors: kInvalidRobot, naming the places looked at.
[[nodiscard]] Expected<std::filesystem::path> findRobotFile(const std::string& robot);

/// The folder that holds the maps/ and robots/ that come along, in the same order. Errors: kInternal.
[[nodiscard]] Expected<std::filesystem::path> findDataFolder();

/// The query of that name as arguments; policy, detour and deadline stay as they were given. Errors:
/// kInvalidRequest, naming the queries there are.
[[nodiscard]] Expected<QueryArguments> queryNamed(const std::string& name, const std::vector<Query>& queries,
                                                  QueryArguments arguments);

/// A plan that is being followed, from its file.
struct FollowedPlan {
  PlanDocument document;
  Executing executing;
};
/// Errors: kInvalidRequest for a file that holds no plan of this robot, or has no such segment.
[[nodiscard]] Expected<FollowedPlan> readFollowed(const FollowArguments& arguments, const Robot& robot);

/// The request for replanning: the plan's, from where the robot is on it. `start` and `goals` of the query,
/// when given, go before the plan's.
[[nodiscard]] Request requestOf(const FollowedPlan& followed, const QueryArguments& query,
                                const Robot& robot);

}  // namespace underway
