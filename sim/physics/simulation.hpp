#pragma once

#include <span>
#include <string>
#include <vector>

#include "gait/joint_table.hpp"
#include "sim/physics/conditions.hpp"
#include "sim/physics/recording.hpp"
#include "sim/physics/scene.hpp"

namespace underway::physics {

/// How the robot is put down.
enum class Posture { kStanding, kLying };

/// One robot in one scene. Plays joint tables as its servos' targets and records what happens. The same
/// conditions and tables give the same motion, bit for bit, on one machine. Thread safety: one thread at a
/// time each.
class Simulation {
 public:
  /// Errors: as of makeModel; kInvalidRobot when a joint that the recordings need is missing.
  [[nodiscard]] static Expected<Simulation> make(const std::filesystem::path& robot, const Scene& scene,
                                                 const Conditions& conditions);

  /// Puts the robot down, its joints as in the table's first row, its body frame at `pose`, just above the
  /// ground, and lets it come to rest.
  void start(const gait::JointTable& table, Posture posture, const Pose& pose);

  /// Plays a table from its first row to its last. Joints that it does not name keep their targets. Targets
  /// move no faster than the servos can. Boxes are told in `frame`. Throws std::invalid_argument when the
  /// robot has no such joint, std::runtime_error when physics diverged.
  Recording play(const gait::JointTable& table, const Pose& frame);
  /// The same, in the body frame now.
  Recording play(const gait::JointTable& table, Posture frame_of);
  /// Keeps the targets for a while.
  Recording hold(double seconds, Posture frame_of);

  /// Puts the robot somewhere else, its joints and its posture as they are: by so much, in the body frame of
  /// the standing robot.
  void carry(const Pose& by);

  /// The robot now; its box in the frame of the ground.
  [[nodiscard]] Sample now() const;
  /// Of one of the robot's joints [rad]. Throws std::invalid_argument when there is none of that name.
  [[nodiscard]] double angle(const std::string& joint) const;
  /// The heading as the torso's IMU tells it: 0 when the robot was put down, running off slowly [rad].
  [[nodiscard]] double imuHeading() const;
  [[nodiscard]] const mjModel_& model() const { return *model_; }

 private:
  Simulation(Model model, Data data, const Conditions& conditions);
  void aim(const gait::JointTable& table, double time_s, std::span<const int> servos);
  [[nodiscard]] std::vector<int> servosOf(const gait::JointTable& table) const;
  void step(Recording& recording);
  void recordContacts(Recording& recording) const;
  [[nodiscard]] Sample sample(const Pose& frame) const;
  [[nodiscard]] Pose frame(Posture posture) const;

  Model model_;
  Data data_;
  Conditions conditions_;
  std::vector<double> targets_rad_;       ///< by servo, as commanded
  std::vector<double> servo_errors_rad_;  ///< by servo
  double imu_drift_radps_ = 0.0;
  double imu_zero_rad_ = 0.0;
};

}  // namespace underway::physics
