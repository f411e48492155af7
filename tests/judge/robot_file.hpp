#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/judge/plane.hpp"

namespace judge {

/// A body as a plan is judged by: its footprint in the body frame, and how high it reaches above the floor
/// [m].
struct Body {
  Rect footprint;
  double height_m = 0.0;
};

struct Mode {
  Body body;
  std::map<std::string, double> speed_mps;  ///< by sense: forward, backward, left, right
  double turn_speed_radps = 0.0;
  double drift_m_per_m = 0.0;
  double step_over_m = 0.0;
};

struct Switch {
  std::string from;
  std::string to;
  double duration_s = 0.0;
  Pose displacement;
  Body body;
};

/// What a robot file says.
struct RobotFile {
  std::string name;
  double margin_m = 0.0;
  std::map<std::string, Mode> modes;
  std::vector<Switch> switches;

  [[nodiscard]] const Mode* findMode(const std::string& mode) const;
  [[nodiscard]] const Switch* findSwitch(const std::string& from, const std::string& to) const;
};

/// Reads robots/*.yaml. Throws InputError.
RobotFile readRobotFile(const std::filesystem::path& file);

}  // namespace judge
