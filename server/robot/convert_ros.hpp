#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/error.hpp"
#include "idl/ros.h"
#include "local/command.hpp"
#include "local/senses.hpp"
#include "server/robot/beams.hpp"

/// Between ROS 2's messages (idl/ros.idl) and what the local layer hears and says. What comes is trusted in
/// nothing. Errors are kInvalidRequest, naming the field. Stamps are seconds of the sender's clock.
namespace underway::ros {

using LaserScan = sensor_msgs_msg_dds__LaserScan_;
using Odometry = nav_msgs_msg_dds__Odometry_;
using Imu = sensor_msgs_msg_dds__Imu_;
using Twist = geometry_msgs_msg_dds__Twist_;
using String = std_msgs_msg_dds__String_;

/// Frees a message and all that it points to.
struct Free {
  void operator()(LaserScan* message) const;
  void operator()(Odometry* message) const;
  void operator()(Imu* message) const;
  void operator()(String* message) const;
};
template <class Message>
using Owned = std::unique_ptr<Message, Free>;

struct Frames {
  std::string map = "map";
  std::string body = "base_link";
};

[[nodiscard]] Owned<LaserScan> toRos(const Scan& scan, double stamp_s, const Frames& frames);
/// As the local layer's scan. What is no measurement (NaN, below range_min, above range_max) tells nothing.
[[nodiscard]] Expected<Scan> fromRos(const LaserScan& message, const Pose& lidar);

/// The velocity is the one that was commanded.
[[nodiscard]] Owned<Odometry> toRos(const PoseEstimate& estimate, const Frames& frames);
[[nodiscard]] Expected<PoseEstimate> fromRos(const Odometry& message);

[[nodiscard]] Owned<Imu> imuOf(double heading_rad, double stamp_s, const Frames& frames);
/// Empty if the message says that it holds no orientation.
[[nodiscard]] Expected<std::optional<double>> headingOf(const Imu& message);

[[nodiscard]] Twist toRos(const Velocity& velocity);
[[nodiscard]] Expected<Velocity> fromRos(const Twist& message);

/// What a robot's gait tells of itself: "crawl cycles=12", "frontal changing", "frontal fallen".
struct GaitState {
  ModeId mode = 0;
  bool is_switching = false;
  bool has_fallen = false;
  std::uint64_t cycles = 0;
  bool operator==(const GaitState&) const = default;
};
[[nodiscard]] std::string textOf(const GaitState& state, const Robot& robot);
[[nodiscard]] Expected<GaitState> gaitStateOf(std::string_view text, const Robot& robot);

[[nodiscard]] Owned<String> stringOf(const std::string& text);
/// Errors: more than 4096 bytes.
[[nodiscard]] Expected<std::string> textOf(const String& message);

/// The moment of a header by the sender's clock [s].
[[nodiscard]] double secondsOf(const builtin_interfaces_msg_dds__Time_& time);

}  // namespace underway::ros
