#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/error.hpp"
#include "geometry/robot.hpp"
#include "geometry/world.hpp"

namespace underway {

/// What cells that nobody has seen are taken for.
enum class Unknown { kOccupied, kFree };

/// How to read a map. All but `unknown` is for an image that comes without its YAML, and refused for other
/// maps.
struct MapOptions {
  Unknown unknown = Unknown::kOccupied;
  std::optional<double> resolution_m;     ///< size of a cell [m]
  std::optional<Pose> origin;             ///< of the lower left corner, in the map frame
  std::optional<double> occupied_thresh;  ///< 0..1
  std::optional<double> free_thresh;      ///< 0..1
  double wall_height_m = 10.0;            ///< of occupied cells, from the floor up [m]
};

/// A query that a scenario file brings along; each is also a test.
struct Query {
  std::string name;
  Pose start;
  std::string start_mode;  ///< empty: the robot's first mode
  Point goal;
  std::optional<double> goal_yaw;     ///< [rad]; empty: any
  std::string goal_mode;              ///< empty: the robot's first mode
  std::string expect;                 ///< "ok" or an error code's name
  std::vector<std::string> must_use;  ///< modes the plan must use
};

struct Map {
  World world;
  std::vector<Query> queries;
};

/// Reads a scenario YAML, a ROS map_server YAML with its image, or an image (PGM, PNG) whose numbers are in
/// the options. Which of them it is, is told by the content. Errors: kInvalidMap, one sentence with file and
/// line.
[[nodiscard]] Expected<Map> readMap(const std::filesystem::path& file, const MapOptions& options = {});

/// Reads robots/*.yaml. Errors: kInvalidRobot, one sentence with file and line.
[[nodiscard]] Expected<Robot> readRobot(const std::filesystem::path& file);

}  // namespace underway
