#include "server/robot/convert_robot.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/world.hpp"
#include "server/robot/beams.hpp"
#include "server/wire_limits.hpp"
#include "server/wire_memory.hpp"

namespace underway {
namespace {

using underway::read;

constexpr std::size_t kMostBeams = 4096;
constexpr double kLargestTime_s = 1e12;
constexpr double kLargestAngle_rad = 1000.0;
constexpr double kFastest = 10.0;  // [m/s], [rad/s]

bool isWithin(double number, double largest) { return std::abs(number) <= largest; }  // false for NaN

tl::unexpected<Error> faulty(const std::string& sentence) {
  return fail(ErrorCode::kInvalidRequest, sentence);
}

/// Whether it was written.
bool write(const Scan* from, underway_Scan& to) {
  if (from == nullptr || from->ranges_m.size() > kMostBeams) return false;
  to.stamp_s = from->stamp_s;
  to.first_rad = from->beams.first_rad;
  to.step_rad = from->beams.step_rad;
  const auto ranges = allocate(to.ranges_m, from->ranges_m.size());
  std::copy(from->ranges_m.begin(), from->ranges_m.end(), ranges.begin());
  return true;
}

/// What is wrong with a scan; empty if nothing is.
std::string faultOf(const underway_Scan& wire) {
  if (!isWithin(wire.stamp_s, kLargestTime_s)) return "stamp_s must be a time in seconds";
  if (!isCounted(wire.ranges_m, kMostBeams)) return "ranges_m must be 4096 numbers at most";
  const bool are_ranges = std::all_of(wire.ranges_m._buffer, wire.ranges_m._buffer + wire.ranges_m._length,
                                      [](float range) { return range >= 0.0F; });  // false for NaN
  if (!are_ranges) return "ranges_m must be numbers of 0 or more, or infinity";
  return faultOf(Beams{wire.ranges_m._length, wire.first_rad, wire.step_rad});
}

Beams beamsOf(const underway_Scan& wire) { return {wire.ranges_m._length, wire.first_rad, wire.step_rad}; }

std::string faultOf(const underway_Senses& wire) {
  if (!isWithin(wire.now_s, kLargestTime_s)) return "now_s must be a time in seconds";
  bool has = false;
  if (!read(wire.has_scan, has)) return "has_scan is neither true nor false";
  if (const std::string fault = has ? faultOf(wire.scan) : ""; !fault.empty()) return "scan: " + fault;
  if (!read(wire.has_depth, has)) return "has_depth is neither true nor false";
  if (const std::string fault = has ? faultOf(wire.depth) : ""; !fault.empty()) return "depth: " + fault;
  if (!read(wire.has_pose, has)) return "has_pose is neither true nor false";
  if (has && !isWithin(wire.pose_stamp_s, kLargestTime_s)) return "pose_stamp_s must be a time in seconds";
  if (has && (!isWithin(wire.pose.x_m, World::kLargest_m) || !isWithin(wire.pose.y_m, World::kLargest_m) ||
              !isWithin(wire.pose.yaw_rad, kLargestAngle_rad)))
    return "pose must be numbers from -100000 to 100000 m and -1000 to 1000 rad";
  if (!read(wire.has_heading, has)) return "has_heading is neither true nor false";
  if (has && !isWithin(wire.heading_rad, kLargestAngle_rad))
    return "heading_rad must be a number from -1000 to 1000 rad";
  if (!read(wire.is_switching, has)) return "is_switching is neither true nor false";
  if (!read(wire.has_fallen, has)) return "has_fallen is neither true nor false";
  return {};
}

/// A mode by its name, or a sentence.
Expected<ModeId> modeOf(std::optional<std::string_view> text, const char* field, const Robot& robot) {
  if (const auto mode = text ? robot.findMode(*text) : std::nullopt) return *mode;
  return faulty(std::string(field) + " must be a mode of robot " + robot.name);
}

}  // namespace

void FreeSenses::operator()(underway_Senses* senses) const {
  dds_sample_free(senses, &underway_Senses_desc, DDS_FREE_ALL);
}

WireSenses toWire(std::uint64_t tick, const Senses& senses, const Robot& robot) {
  WireSenses wire(allocate<underway_Senses>());
  wire->tick = tick;
  wire->now_s = senses.now_s;
  wire->has_scan = write(senses.scan, wire->scan);
  wire->has_depth = write(senses.depth, wire->depth);
  wire->has_pose = senses.pose.has_value();
  if (senses.pose) {
    const Pose& pose = senses.pose->pose;
    wire->pose_stamp_s = senses.pose->stamp_s;
    wire->pose = {pose.x, pose.y, pose.yaw};
  }
  wire->has_heading = senses.heading_rad.has_value();
  wire->heading_rad = senses.heading_rad.value_or(0.0);
  (void)copyText(robot.modes.at(senses.mode).name, wire->mode);  // cut names match no mode and are refused
  wire->is_switching = senses.is_switching;
  wire->cycles = senses.cycles;
  wire->has_fallen = senses.has_fallen;
  return wire;
}

Expected<HeardSenses> fromWire(const underway_Senses& wire, const Robot& robot) {
  if (const std::string fault = faultOf(wire); !fault.empty()) return faulty(fault);
  const Expected<ModeId> mode = modeOf(textOf(wire.mode), "mode", robot);
  if (!mode) return tl::unexpected(mode.error());
  HeardSenses heard;
  heard.tick = wire.tick;
  Senses& rest = heard.rest;
  rest.now_s = wire.now_s;
  rest.mode = *mode;
  rest.is_switching = wire.is_switching;
  rest.cycles = wire.cycles;
  rest.has_fallen = wire.has_fallen;
  if (wire.has_pose)
    rest.pose = {wire.pose_stamp_s, {wire.pose.x_m, wire.pose.y_m, normalizedAngle(wire.pose.yaw_rad)}};
  if (wire.has_heading) rest.heading_rad = normalizedAngle(wire.heading_rad);
  if (wire.has_scan)
    heard.scan = asStandardScan(beamsOf(wire.scan), {wire.scan.ranges_m._buffer, wire.scan.ranges_m._length},
                                wire.scan.stamp_s);
  if (wire.has_depth) {
    const auto& ranges = wire.depth.ranges_m;
    heard.depth = Scan{wire.depth.stamp_s, beamsOf(wire.depth), {}};
    heard.depth->ranges_m.assign(ranges._buffer, ranges._buffer + ranges._length);
  }
  return heard;
}

underway_Command toWire(std::uint64_t tick, const Command& command, const Robot& robot) {
  underway_Command wire{};
  wire.tick = tick;
  wire.x_mps = command.velocity.x_mps;
  wire.y_mps = command.velocity.y_mps;
  wire.turn_radps = command.velocity.turn_radps;
  if (command.change_to) (void)copyText(robot.modes.at(*command.change_to).name, wire.change_to);
  wire.look_rad = command.look_rad;
  return wire;
}

Expected<HeardCommand> fromWire(const underway_Command& wire, const Robot& robot) {
  if (!isWithin(wire.x_mps, kFastest) || !isWithin(wire.y_mps, kFastest) ||
      !isWithin(wire.turn_radps, kFastest))
    return faulty("the velocity must be numbers from -10 to 10 m/s and rad/s");
  if (!isWithin(wire.look_rad, kFastest)) return faulty("look_rad must be a number from -10 to 10 rad");
  HeardCommand heard{wire.tick, {{wire.x_mps, wire.y_mps, wire.turn_radps}, std::nullopt, wire.look_rad}};
  if (const auto text = textOf(wire.change_to); text && text->empty()) return heard;
  const Expected<ModeId> mode = modeOf(textOf(wire.change_to), "change_to", robot);
  if (!mode) return tl::unexpected(mode.error());
  heard.command.change_to = *mode;
  return heard;
}

}  // namespace underway
