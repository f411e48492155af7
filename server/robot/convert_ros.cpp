#include "server/robot/convert_ros.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "geometry/world.hpp"
#include "server/wire_memory.hpp"

namespace underway::ros {
namespace {

constexpr std::size_t kMostBeams = 16384;
constexpr double kFastest = 10.0;  // [m/s], [rad/s]

tl::unexpected<Error> faulty(const std::string& sentence) {
  return fail(ErrorCode::kInvalidRequest, sentence);
}

builtin_interfaces_msg_dds__Time_ timeOf(double stamp_s) {
  constexpr double kNanos = 1e9;
  const double whole = std::floor(stamp_s);
  const double nanos = std::min((stamp_s - whole) * kNanos, kNanos - 1.0);
  return {static_cast<std::int32_t>(whole), static_cast<std::uint32_t>(nanos)};
}

std_msgs_msg_dds__Header_ headerOf(double stamp_s, const std::string& frame) {
  return {timeOf(stamp_s), wireText(frame)};
}

geometry_msgs_msg_dds__Quaternion_ quaternionOf(double yaw_rad) {
  return {0.0, 0.0, std::sin(0.5 * yaw_rad), std::cos(0.5 * yaw_rad)};
}

/// The heading of an orientation; empty if it is none.
std::optional<double> yawOf(const geometry_msgs_msg_dds__Quaternion_& q) {
  constexpr double kOff = 0.01;
  const double size = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!(std::abs(size - 1.0) < kOff)) return std::nullopt;  // also for NaN
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

/// What is wrong with a scan's angles and counts; empty if nothing is.
std::string faultOf(const LaserScan& message) {
  if (!isCounted(message.ranges, kMostBeams)) return "ranges must be 16384 at most";
  if (!(message.range_min >= 0.0F) || !(message.range_max > message.range_min))
    return "range_min and range_max must be 0 or more, in this order";
  const double step = message.angle_increment;
  const Beams beams{message.ranges._length, message.angle_min, step};
  if (const std::string fault = underway::faultOf(beams); !fault.empty())
    return "angle_min or angle_increment: " + fault;
  if (beams.count == 0) return {};
  // Drivers do not agree whether angle_max is the last beam or the end behind it.
  const double spanned = (static_cast<double>(message.angle_max) - message.angle_min) / step;
  if (!(std::abs(spanned - static_cast<double>(beams.count) + 0.5) < 1.5))
    return "ranges are " + std::to_string(beams.count) + ", but the angles say " +
           (std::isfinite(spanned) ? std::to_string(std::lround(std::clamp(spanned, -1e6, 1e6)) + 1)
                                   : "nothing");
  return {};
}

}  // namespace

void Free::operator()(LaserScan* message) const {
  dds_sample_free(message, &sensor_msgs_msg_dds__LaserScan__desc, DDS_FREE_ALL);
}
void Free::operator()(Odometry* message) const {
  dds_sample_free(message, &nav_msgs_msg_dds__Odometry__desc, DDS_FREE_ALL);
}
void Free::operator()(Imu* message) const {
  dds_sample_free(message, &sensor_msgs_msg_dds__Imu__desc, DDS_FREE_ALL);
}
void Free::operator()(String* message) const {
  dds_sample_free(message, &std_msgs_msg_dds__String__desc, DDS_FREE_ALL);
}

double secondsOf(const builtin_interfaces_msg_dds__Time_& time) { return time.sec + 1e-9 * time.nanosec; }

// --- scans -------------------------------------------------------------------------------------------------

Owned<LaserScan> toRos(const Scan& scan, double stamp_s, const Frames& frames) {
  constexpr float kTick_s = 0.1F;
  constexpr float kFarthest_m = 100.0F;
  Owned<LaserScan> message(allocate<LaserScan>());
  const Beams& beams = scan.beams;
  message->header = headerOf(stamp_s, frames.body);
  message->angle_min = static_cast<float>(beams.first_rad);
  message->angle_max = static_cast<float>(beams.bearing(beams.count - 1));
  message->angle_increment = static_cast<float>(beams.step_rad);
  message->scan_time = kTick_s;
  message->range_max = kFarthest_m;
  const auto ranges = allocate(message->ranges, scan.ranges_m.size());
  std::copy(scan.ranges_m.begin(), scan.ranges_m.end(), ranges.begin());
  (void)allocate(message->intensities, 0);
  return message;
}

Expected<Scan> fromRos(const LaserScan& message, const Pose& lidar) {
  if (const std::string fault = faultOf(message); !fault.empty()) return faulty(fault);
  const std::size_t count = message.ranges._length;
  std::vector<float> ranges(message.ranges._buffer, message.ranges._buffer + count);
  for (float& range : ranges)
    if (range > message.range_max) range = Scan::kNothing;
  // Between the beams the last counts as well as the first: an increment told in single precision adds up.
  const double last = count > 1 ? (static_cast<double>(message.angle_max) - message.angle_min) /
                                      static_cast<double>(count - 1)
                                : message.angle_increment;
  const bool is_last = std::abs(last - message.angle_increment) < 1e-4 * std::abs(last);
  const Beams beams{count, message.angle_min, is_last ? last : message.angle_increment};
  return asStandardScan(beams, ranges, secondsOf(message.header.stamp), {lidar, message.range_min});
}

// --- poses and headings ------------------------------------------------------------------------------------

Owned<Odometry> toRos(const PoseEstimate& estimate, const Frames& frames) {
  Owned<Odometry> message(allocate<Odometry>());
  message->header = headerOf(estimate.stamp_s, frames.map);
  message->child_frame_id = wireText(frames.body);
  message->pose.pose = {{estimate.pose.x, estimate.pose.y, 0.0}, quaternionOf(estimate.pose.yaw)};
  return message;
}

Expected<PoseEstimate> fromRos(const Odometry& message) {
  const auto& position = message.pose.pose.position;
  if (!(std::abs(position.x) <= World::kLargest_m) || !(std::abs(position.y) <= World::kLargest_m))
    return faulty("pose.position must be numbers from -100000 to 100000 m");
  const std::optional<double> yaw = yawOf(message.pose.pose.orientation);
  if (!yaw) return faulty("pose.orientation must be a unit quaternion");
  return PoseEstimate{secondsOf(message.header.stamp), {position.x, position.y, *yaw}};
}

Owned<Imu> imuOf(double heading_rad, double stamp_s, const Frames& frames) {
  Owned<Imu> message(allocate<Imu>());
  message->header = headerOf(stamp_s, frames.body);
  message->orientation = quaternionOf(heading_rad);
  message->angular_velocity_covariance[0] = -1.0;  // nothing is told of these
  message->linear_acceleration_covariance[0] = -1.0;
  return message;
}

Expected<std::optional<double>> headingOf(const Imu& message) {
  if (message.orientation_covariance[0] == -1.0) return std::optional<double>();
  const std::optional<double> yaw = yawOf(message.orientation);
  if (!yaw) return faulty("orientation must be a unit quaternion");
  return yaw;
}

// --- commands ----------------------------------------------------------------------------------------------

Twist toRos(const Velocity& velocity) {
  return {{velocity.x_mps, velocity.y_mps, 0.0}, {0.0, 0.0, velocity.turn_radps}};
}

Expected<Velocity> fromRos(const Twist& message) {
  const auto is_within = [](double number) { return std::abs(number) <= kFastest; };  // false for NaN
  if (!is_within(message.linear.x) || !is_within(message.linear.y) || !is_within(message.angular.z))
    return faulty("linear and angular must be numbers from -10 to 10 m/s and rad/s");
  return Velocity{message.linear.x, message.linear.y, message.angular.z};
}

// --- modes -------------------------------------------------------------------------------------------------

std::string textOf(const GaitState& state, const Robot& robot) {
  std::string text = robot.modes.at(state.mode).name;
  if (state.is_switching) text += " changing";
  if (state.has_fallen) text += " fallen";
  if (state.cycles > 0) text += " cycles=" + std::to_string(state.cycles);
  return text;
}

Expected<GaitState> gaitStateOf(std::string_view text, const Robot& robot) {
  constexpr std::string_view kCycles = "cycles=";
  GaitState state;
  for (bool is_first = true; is_first || !text.empty(); is_first = false) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    const auto mode = is_first ? robot.findMode(word) : std::nullopt;
    if (is_first && !mode) return faulty("data must begin with a mode of robot " + robot.name);
    if (is_first) {
      state.mode = *mode;
    } else if (word == "changing") {
      state.is_switching = true;
    } else if (word == "fallen") {
      state.has_fallen = true;
    } else if (word.starts_with(kCycles)) {
      const char* const end = word.data() + word.size();
      const auto [stopped, error] = std::from_chars(word.data() + kCycles.size(), end, state.cycles);
      if (error != std::errc{} || stopped != end) return faulty("data: cycles= must be followed by a count");
    } else if (!word.empty()) {
      return faulty("data must be a mode, then changing, fallen or cycles=N");
    }
  }
  return state;
}

Owned<String> stringOf(const std::string& text) {
  Owned<String> message(allocate<String>());
  message->data = wireText(text);
  return message;
}

Expected<std::string> textOf(const String& message) {
  std::string text;
  if (!underway::read(message.data, text)) return faulty("data must be a text of 4096 bytes at most");
  return text;
}

}  // namespace underway::ros
