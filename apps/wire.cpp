#include "apps/wire.hpp"

namespace underway {

void addWire(CLI::App& command, WireArguments& arguments) {
  command.add_option("--name", arguments.name, "The robot's name, which tells robots apart (nao)")
      ->type_name("NAME");
  addDomain(command, arguments.domain);
  CLI::Option* const ros =
      command.add_flag("--ros", arguments.is_ros, "Talk to the robot by ROS 2's topics rather than our own");
  RosTopics& topics = arguments.topics;
  const auto add = [&](const char* flag, std::string& topic, const std::string& help) {
    command.add_option(flag, topic, help + " (" + topic + ")")->type_name("TOPIC")->needs(ros);
  };
  add("--scan-topic", topics.scan, "sensor_msgs/LaserScan");
  add("--odom-topic", topics.odom, "nav_msgs/Odometry, its pose in the map frame");
  add("--imu-topic", topics.imu, "sensor_msgs/Imu, its heading in the map frame");
  add("--cmd-vel-topic", topics.cmd_vel, "geometry_msgs/Twist");
  add("--mode-topic", topics.mode, "std_msgs/String, the mode to change to");
  add("--mode-state-topic", topics.mode_state, "std_msgs/String, what the gait does");
  addPose(command, "--lidar", arguments.topics.lidar,
          "Where the lidar is in the body frame [m, m, rad] (0,0,0)")
      ->needs(ros);
}

Expected<std::unique_ptr<RobotEnd>> openRobotEnd(const WireArguments& arguments, const Domain& domain,
                                                 std::shared_ptr<const Robot> robot) {
  return arguments.is_ros ? openRosRobotEnd(domain, arguments.topics, std::move(robot))
                          : openRobotEnd(domain, arguments.name, std::move(robot));
}

Expected<std::unique_ptr<DriverEnd>> openDriverEnd(const WireArguments& arguments, const Domain& domain,
                                                   std::shared_ptr<const Robot> robot) {
  return arguments.is_ros ? openRosDriverEnd(domain, arguments.topics, std::move(robot))
                          : openDriverEnd(domain, arguments.name, std::move(robot));
}

}  // namespace underway
