#include <algorithm>

#include "geometry/map.hpp"
#include "geometry/read/bytes.hpp"
#include "geometry/read/yaml.hpp"

namespace underway {
namespace {

constexpr auto kInvalid = ErrorCode::kInvalidRobot;

Range rangeOf(const YamlValue& value) {
  const std::vector<double> ends = value.numbers(2, 2);
  if (ends[0] >= ends[1]) value.refuse("must be [min, max] with min below max");
  return {ends[0], ends[1]};
}

BodyBox bodyOf(const YamlValue& value) {
  value.allowOnly({"x", "y", "z"});
  return {rangeOf(value.at("x")), rangeOf(value.at("y")), rangeOf(value.at("z"))};
}

std::array<double, 4> speedsOf(const YamlValue& value) {
  value.allowOnly({name(Sense::kForward), name(Sense::kBackward), name(Sense::kLeft), name(Sense::kRight)});
  std::array<double, 4> speeds{};
  for (const Sense sense : kSenses)
    speeds[static_cast<std::size_t>(sense)] = value.find(name(sense)).number(0.0);
  return speeds;
}

Mode modeOf(const YamlValue& value) {
  value.allowOnly({"body_m", "speed_mps", "turn_speed_radps", "drift_m_per_m", "step_over_m"});
  Mode mode;
  mode.name = value.key();
  mode.body_m = bodyOf(value.at("body_m"));
  mode.speed_mps = speedsOf(value.at("speed_mps"));
  mode.turn_speed_radps = value.at("turn_speed_radps").number();
  mode.drift_m_per_m = value.find("drift_m_per_m").number(0.0);
  mode.step_over_m = value.find("step_over_m").number(0.0);
  return mode;
}

Pose displacementOf(const YamlValue& value) {
  if (!value) return {};
  value.allowOnly({"x_m", "y_m", "yaw_rad"});
  return {value.find("x_m").number(0.0), value.find("y_m").number(0.0), value.find("yaw_rad").number(0.0)};
}

ModeId modeIdOf(const YamlValue& value, const Robot& robot) {
  const std::string mode_name = value.text();
  if (const auto id = robot.findMode(mode_name)) return *id;
  std::vector<std::string> known;
  for (const Mode& mode : robot.modes) known.push_back(mode.name);
  value.refuse("unknown mode " + inQuotes(mode_name) + "; the modes are " + listed(known));
  return 0;
}

Switch switchOf(const YamlValue& value, const Robot& robot) {
  value.allowOnly({"from", "to", "duration_s", "displacement", "body_m"});
  Switch change;
  change.from = modeIdOf(value.at("from"), robot);
  change.to = modeIdOf(value.at("to"), robot);
  change.duration_s = value.at("duration_s").number();
  change.displacement = displacementOf(value.find("displacement"));
  if (const YamlValue body = value.find("body_m")) change.body_m = bodyOf(body);
  return change;
}

SensesOfRobot sensesOf(const YamlValue& value) {
  SensesOfRobot senses;
  if (!value) return senses;
  value.allowOnly({"waist", "head", "depth"});
  for (const auto& [key, lidar] : {std::pair{"waist", &senses.waist}, std::pair{"head", &senses.head}})
    if (const YamlValue sense = value.find(key)) {
      sense.allowOnly({"height_m"});
      *lidar = {sense.at("height_m").number()};
    }
  if (const YamlValue sense = value.find("depth")) {
    sense.allowOnly({"field_rad", "farthest_m"});
    senses.depth = {sense.at("field_rad").number(), sense.at("farthest_m").number()};
  }
  return senses;
}

/// Refuses, on the line of the piece that was just added, what makes the robot unsound.
void refuseUnlessSound(const YamlValue& piece, const Robot& robot) {
  if (const auto checked = checkedRobot(robot); !checked) piece.refuse(checked.error().message);
}

}  // namespace

Expected<Robot> readRobot(const std::filesystem::path& file) {
  const auto bytes = readBytes(file, kLargestYaml, kInvalid);
  if (!bytes) return tl::unexpected(bytes.error());
  auto yaml = parseYaml(file, *bytes, kInvalid);
  if (!yaml) return tl::unexpected(yaml.error());

  const YamlValue root = yaml->root();
  root.allowOnly({"name", "margin_m", "modes", "switches", "senses"});
  Robot robot;
  robot.name = root.at("name").text();
  const YamlValue margin = root.at("margin_m");
  robot.margin_m = margin.number();
  if (robot.margin_m < 0.0) margin.refuse("must be 0 or more");

  // The robot is checked whenever it has grown, so that the first fault is told with its line.
  const YamlValue modes = root.at("modes");
  if (modes.isMapping() && modes.members().empty()) modes.refuse("is empty; give at least one mode");
  for (const YamlValue& mode : modes.members()) {
    if (yaml->fault()) break;
    robot.modes.push_back(modeOf(mode));
    refuseUnlessSound(mode, robot);
  }
  for (const YamlValue& change : root.find("switches").items()) {
    if (yaml->fault()) break;
    robot.switches.push_back(switchOf(change, robot));
    refuseUnlessSound(change, robot);
  }
  if (const YamlValue senses = root.find("senses"); senses && !yaml->fault()) {
    robot.senses = sensesOf(senses);
    refuseUnlessSound(senses, robot);
  }
  if (yaml->fault()) return tl::unexpected(*yaml->fault());
  return checkedRobot(std::move(robot));
}

}  // namespace underway
