#include "tests/judge/robot_file.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "tests/judge/image.hpp"

namespace judge {
namespace {

Body bodyOf(const YAML::Node& node) {
  const auto range = [&](const char* axis) { return node[axis].as<std::vector<double>>(); };
  return {{range("x").at(0), range("x").at(1), range("y").at(0), range("y").at(1)}, range("z").at(1)};
}

Mode modeOf(const YAML::Node& node) {
  return {bodyOf(node["body_m"]), node["speed_mps"].as<std::map<std::string, double>>(),
          node["turn_speed_radps"].as<double>(0.0), node["drift_m_per_m"].as<double>(0.0),
          node["step_over_m"].as<double>(0.0)};
}

/// A switch whose body is not given covers the old body where it is and the new one where the displacement
/// puts it.
Body hullOf(const Body& before, const Body& after, const Pose& displacement) {
  Body body = before;
  Rect& hull = body.footprint;
  for (const Vec2 corner : placed(displacement, after.footprint)) {
    hull = {std::min(hull.x_min, corner.x), std::max(hull.x_max, corner.x), std::min(hull.y_min, corner.y),
            std::max(hull.y_max, corner.y)};
  }
  body.height_m = std::max(before.height_m, after.height_m);
  return body;
}

Switch switchOf(const YAML::Node& node, const RobotFile& robot) {
  Switch change{
      node["from"].as<std::string>(), node["to"].as<std::string>(), node["duration_s"].as<double>(), {}, {}};
  if (const YAML::Node by = node["displacement"])
    change.displacement = {by["x_m"].as<double>(0.0), by["y_m"].as<double>(0.0),
                           by["yaw_rad"].as<double>(0.0)};
  const Mode* from = robot.findMode(change.from);
  const Mode* to = robot.findMode(change.to);
  if (from == nullptr || to == nullptr)
    throw InputError("switch " + change.from + " -> " + change.to + " names a mode that does not exist");
  change.body = node["body_m"] ? bodyOf(node["body_m"]) : hullOf(from->body, to->body, change.displacement);
  return change;
}

}  // namespace

const Mode* RobotFile::findMode(const std::string& mode) const {
  const auto found = modes.find(mode);
  return found == modes.end() ? nullptr : &found->second;
}

const Switch* RobotFile::findSwitch(const std::string& from, const std::string& to) const {
  const auto found = std::find_if(switches.begin(), switches.end(), [&](const Switch& change) {
    return change.from == from && change.to == to;
  });
  return found == switches.end() ? nullptr : &*found;
}

RobotFile readRobotFile(const std::filesystem::path& file) try {
  const YAML::Node yaml = YAML::LoadFile(file);
  RobotFile robot;
  robot.name = yaml["name"].as<std::string>();
  robot.margin_m = yaml["margin_m"].as<double>();
  for (const auto& entry : yaml["modes"]) robot.modes[entry.first.as<std::string>()] = modeOf(entry.second);
  for (const YAML::Node& node : yaml["switches"]) robot.switches.push_back(switchOf(node, robot));
  return robot;
} catch (const YAML::Exception& error) {
  throw InputError(file.string() + ": " + error.what());
} catch (const std::out_of_range&) {
  throw InputError(file.string() + ": a range needs two numbers");
}

}  // namespace judge
