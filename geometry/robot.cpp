#include "geometry/robot.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include "geometry/fingerprint.hpp"

namespace underway {
namespace {

constexpr double kLargestBody_m = 100.0;
constexpr double kLargestSpeed_mps = 100.0;
constexpr double kSlowest = 1e-4;  // [m/s], [rad/s]: slower is no movement, and its times would fit no field

bool isAtLeast(double value, double least) { return std::isfinite(value) && value >= least; }
bool isSpeed(double value) { return value == 0.0 || isAtLeast(value, kSlowest); }
bool holds(Range outer, Range inner) {
  return outer.min <= inner.min + 1e-9 && outer.max >= inner.max - 1e-9;
}

/// What is wrong with a body, or nothing.
std::string faultOf(const BodyBox& body) {
  const std::pair<const char*, Range> ranges[] = {{"x", body.x}, {"y", body.y}, {"z", body.z}};
  for (const auto& [axis, range] : ranges) {
    if (!std::isfinite(range.min) || !std::isfinite(range.max) || !(range.min < range.max))
      return std::string("body_m.") + axis + " must be [min, max] with min below max";
    if (std::max(std::abs(range.min), std::abs(range.max)) > kLargestBody_m)
      return std::string("body_m.") + axis + " is larger than 100 m";
  }
  if (body.z.min < 0.0) return "body_m.z must begin at 0 (the floor) or above";
  // Below the step-over floor of 5 mm there is nothing to see, so such a body would never collide.
  if (body.z.max <= 0.005) return "body_m.z must reach above 0.005 m";
  return {};
}

std::string faultOf(const Mode& mode) {
  if (mode.name.empty()) return "has no name";
  if (const std::string fault = faultOf(mode.body_m); !fault.empty()) return fault;
  for (const Sense sense : kSenses)
    if (!isSpeed(mode.speed(sense)) || mode.speed(sense) > kLargestSpeed_mps)
      return "speed_mps." + std::string(name(sense)) + " must be 0 or between 0.0001 and 100 m/s";
  if (!isSpeed(mode.turn_speed_radps)) return "turn_speed_radps must be 0 or at least 0.0001 rad/s";
  if (!isAtLeast(mode.drift_m_per_m, 0.0) || mode.drift_m_per_m > 1.0)
    return "drift_m_per_m must be between 0 and 1";
  if (!isAtLeast(mode.step_over_m, 0.0) || mode.step_over_m >= mode.body_m.z.max)
    return "step_over_m must be 0 or more and below the body's height";
  return {};
}

/// The box, in the old body frame, round the old body where it is and the new one where the displacement puts
/// it.
BodyBox hullOfBoth(const Switch& change, const Robot& robot) {
  BodyBox box = robot.modes[change.from].body_m;
  const BodyBox& next = robot.modes[change.to].body_m;
  for (const double x : {next.x.min, next.x.max}) {
    for (const double y : {next.y.min, next.y.max}) {
      const Point corner = transform(change.displacement, {x, y});
      box.x = hull(box.x, {corner.x, corner.x});
      box.y = hull(box.y, {corner.y, corner.y});
    }
  }
  box.z = hull(box.z, next.z);
  return box;
}

std::string faultOf(const Switch& change, const Robot& robot) {
  if (change.from >= robot.modes.size() || change.to >= robot.modes.size())
    return "names a mode that does not exist";
  if (change.from == change.to) return "leads from a mode to itself";
  if (!isAtLeast(change.duration_s, 0.0)) return "duration_s must be 0 or more";
  const Pose& by = change.displacement;
  if (!std::isfinite(by.x) || !std::isfinite(by.y) || !std::isfinite(by.yaw))
    return "displacement must be finite";
  if (const std::string fault = faultOf(change.body_m); !fault.empty()) return fault;
  // What the box covers in between is the file's word; this much can be seen to be wrong.
  const bool holds_way = holds(change.body_m.x, hull({0.0, 0.0}, {by.x, by.x})) &&
                         holds(change.body_m.y, hull({0.0, 0.0}, {by.y, by.y}));
  if (!holds_way || !holds(change.body_m.z, hullOfBoth(change, robot).z))
    return "body_m must cover the whole motion: the way of the displacement, at the height of both modes' "
           "bodies";
  return {};
}

std::string faultOf(const SensesOfRobot& senses) {
  for (const auto& [name, lidar] : {std::pair{"waist", senses.waist}, std::pair{"head", senses.head}})
    if (lidar && !(isAtLeast(lidar->height_m, 0.0) && lidar->height_m <= kLargestBody_m))
      return std::string("senses.") + name + ".height_m must be between 0 and 100 m";
  if (!senses.depth) return {};
  if (!isAtLeast(senses.depth->field_rad, 0.01) || senses.depth->field_rad > 2.0 * std::numbers::pi)
    return "senses.depth.field_rad must be between 0.01 and 6.28 rad";
  if (!isAtLeast(senses.depth->farthest_m, 0.1) || senses.depth->farthest_m > kLargestBody_m)
    return "senses.depth.farthest_m must be between 0.1 and 100 m";
  return {};
}

std::string labelOf(const Switch& change, const Robot& robot) {
  const auto mode_name = [&](ModeId id) {
    return id < robot.modes.size() ? robot.modes[id].name : std::string("?");
  };
  return "switch " + mode_name(change.from) + " -> " + mode_name(change.to);
}

}  // namespace

std::string_view name(Sense sense) {
  static constexpr std::array<std::string_view, 4> kNames{"forward", "backward", "left", "right"};
  return kNames.at(static_cast<std::size_t>(sense));
}

double angleOf(Sense sense) {
  constexpr double kPi = std::numbers::pi;
  static constexpr std::array<double, 4> kAngles{0.0, kPi, kPi / 2.0, -kPi / 2.0};
  return kAngles.at(static_cast<std::size_t>(sense));
}

Sense opposite(Sense sense) {
  static constexpr std::array<Sense, 4> kOpposites{Sense::kBackward, Sense::kForward, Sense::kRight,
                                                   Sense::kLeft};
  return kOpposites.at(static_cast<std::size_t>(sense));
}

std::optional<ModeId> Robot::findMode(std::string_view mode_name) const {
  for (std::size_t id = 0; id < modes.size(); ++id)
    if (modes[id].name == mode_name) return static_cast<ModeId>(id);
  return std::nullopt;
}

const Switch* Robot::findSwitch(ModeId from, ModeId to) const {
  for (const Switch& change : switches)
    if (change.from == from && change.to == to) return &change;
  return nullptr;
}

Expected<Robot> checkedRobot(Robot robot) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorCode::kInvalidRobot, "robot \"" + robot.name + "\": " + what);
  };
  if (robot.name.empty()) return refuse("has no name; give it one");
  if (!isAtLeast(robot.margin_m, 0.0) || robot.margin_m > kLargestBody_m)
    return refuse("margin_m must be 0 or more");
  if (robot.modes.empty()) return refuse("has no modes; give it at least one");
  if (robot.modes.size() > kMaxModes)
    return refuse("has " + std::to_string(robot.modes.size()) + " modes; at most " +
                  std::to_string(kMaxModes) + " can be ranked");
  std::set<std::string> names;
  for (const Mode& mode : robot.modes) {
    if (const std::string fault = faultOf(mode); !fault.empty())
      return refuse("mode \"" + mode.name + "\": " + fault);
    if (!names.insert(mode.name).second) return refuse("mode \"" + mode.name + "\" is given twice");
  }
  std::set<std::pair<ModeId, ModeId>> pairs;
  for (Switch& change : robot.switches) {
    const bool known = change.from < robot.modes.size() && change.to < robot.modes.size();
    if (known && change.body_m == BodyBox{}) change.body_m = hullOfBoth(change, robot);
    if (const std::string fault = faultOf(change, robot); !fault.empty())
      return refuse(labelOf(change, robot) + ": " + fault);
    if (!pairs.insert({change.from, change.to}).second)
      return refuse(labelOf(change, robot) + " is given twice");
  }
  if (const std::string fault = faultOf(robot.senses); !fault.empty()) return refuse(fault);
  return robot;
}

std::string hashOf(const Robot& robot) {
  Fingerprint print;
  const auto add_body = [&](const BodyBox& body) {
    for (const Range range : {body.x, body.y, body.z}) print.add(range.min).add(range.max);
  };
  print.add(robot.name).add(robot.margin_m);
  for (const Mode& mode : robot.modes) {
    print.add(mode.name);
    add_body(mode.body_m);
    for (const double speed : mode.speed_mps) print.add(speed);
    print.add(mode.turn_speed_radps).add(mode.drift_m_per_m).add(mode.step_over_m);
  }
  for (const Switch& change : robot.switches) {
    print.add(std::uint64_t{change.from}).add(std::uint64_t{change.to}).add(change.duration_s);
    print.add(change.displacement.x).add(change.displacement.y).add(change.displacement.yaw);
    add_body(change.body_m);
  }
  return print.hex();
}

}  // namespace underway
