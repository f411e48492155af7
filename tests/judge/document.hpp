#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/judge/plane.hpp"

namespace judge {

struct Nearest {
  std::string id;
  Vec2 at;
};

struct Segment {
  std::string kind;  ///< translate, turn, arc or switch
  std::string mode;
  std::string to_mode;  ///< the mode afterwards; the same as `mode` unless the kind is switch
  std::string sense;    ///< of a translation
  Pose from;
  Pose to;
  double angle_rad = 0.0;  ///< of a turn or an arc
  Vec2 center;             ///< of an arc
  double duration_s = 0.0;
  double clearance_m = 0.0;
  std::optional<double> headroom_m;
  std::optional<Nearest> nearest;
};

struct Document {
  std::string status;
  std::string message;
  std::string robot;
  std::string map;
  Pose start;
  std::string start_mode;
  Vec2 goal;
  std::optional<double> goal_yaw;
  std::string goal_mode;
  double total_time_s = 0.0;
  double length_m = 0.0;
  std::vector<Segment> segments;
};

/// Reads a plan file. Every missing key, wrong type and unknown word becomes a violation; then nothing is
/// returned.
std::optional<Document> readDocument(std::string_view text, std::vector<std::string>& violations);

}  // namespace judge
