#pragma once

#include <memory>
#include <optional>
#include <string>

#include "geometry/robot.hpp"
#include "server/domain.hpp"
#include "server/robot/robot_end.hpp"

namespace underway {

/// The names of ROS 2 topics that a robot's senses and commands go by, without a leading '/', and its frames.
///
/// `odom` has to give the pose in the map frame, whatever its frame is called. `mode_state` is told ten times
/// a second: a mode of the robot file, then, each after a blank and only if so, `changing`, `fallen` and
/// `cycles=N` (crawl cycles completed). A robot that has one mode alone may do without `mode` and
/// `mode_state`, and any robot without `imu`, whose heading counts only while there is no pose.
struct RosTopics {
  std::string scan = "scan";                       ///< sensor_msgs/LaserScan
  std::string odom = "odom";                       ///< nav_msgs/Odometry
  std::string imu = "imu";                         ///< sensor_msgs/Imu
  std::string cmd_vel = "cmd_vel";                 ///< geometry_msgs/Twist, in the body frame
  std::string mode = "underway/mode";              ///< std_msgs/String: the mode to change to
  std::string mode_state = "underway/mode_state";  ///< std_msgs/String
  std::optional<Pose> lidar;                       ///< in the body frame; empty: it is that
};

/// A robot's wire by ROS 2's topics, as they are on DDS. Errors: kInvalidRequest for a name that cannot be a
/// topic's, kInternal when DDS refuses.
[[nodiscard]] Expected<std::unique_ptr<RobotEnd>> openRosRobotEnd(const Domain& domain,
                                                                  const RosTopics& topics,
                                                                  std::shared_ptr<const Robot> robot);
[[nodiscard]] Expected<std::unique_ptr<DriverEnd>> openRosDriverEnd(const Domain& domain,
                                                                    const RosTopics& topics,
                                                                    std::shared_ptr<const Robot> robot);

}  // namespace underway
