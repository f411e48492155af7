#pragma once

#include <memory>
#include <string>

#include "apps/arguments.hpp"
#include "server/robot/robot_end.hpp"
#include "server/robot/ros_ends.hpp"

namespace underway {

/// How a robot is talked to: which one, where, and by which topics.
struct WireArguments {
  std::string name = "nao";
  DomainSettings domain;
  bool is_ros = false;
  RosTopics topics;
};
/// --name, --domain, --network, --ros and the names of ROS topics.
void addWire(CLI::App& command, WireArguments& arguments);

/// The ends of a robot's wire, as the arguments say.
[[nodiscard]] Expected<std::unique_ptr<RobotEnd>> openRobotEnd(const WireArguments& arguments,
                                                               const Domain& domain,
                                                               std::shared_ptr<const Robot> robot);
[[nodiscard]] Expected<std::unique_ptr<DriverEnd>> openDriverEnd(const WireArguments& arguments,
                                                                 const Domain& domain,
                                                                 std::shared_ptr<const Robot> robot);

}  // namespace underway
