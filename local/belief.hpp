#pragma once

#include <array>

#include "geometry/pose.hpp"
#include "local/command.hpp"
#include "local/senses.hpp"

namespace underway {

struct BeliefSettings {
  double gain = 0.08;          ///< how much of a difference to the measured position is believed
  double heading_gain = 0.08;  ///< and to the measured heading
  double drift_gain = 0.06;    ///< how fast the gait's heading drift is learnt while walking [1/m]
  double tick_s = 0.1;
};

/// Where the robot believes it is: dead reckoning by its own commands, corrected by what localisation says.
/// A measurement is compared with the belief of the moment it is of, so that being late costs nothing; of
/// those that come first, or after a time without any, more is believed. Allocates nothing.
class Belief {
 public:
  explicit Belief(const BeliefSettings& settings) : settings_(settings) {}

  /// The robot is here; forgets all else.
  void set(const Pose& pose);
  /// What the last command has moved it by, in its body frame.
  void move(double x_m, double y_m, double turn_rad);
  /// A change of mode has moved it by this, in its body frame.
  void jump(const Pose& displacement);
  /// What localisation says, or while it is silent the inertial heading alone. While it lies, what that says
  /// along the body is passed over: the belief is told of strokes when they have ended.
  void correct(const Senses& senses, bool is_lying = false);
  /// Fixes are counted anew.
  void countAnew() { fixes_ = 0, weight_ = 1.0; }
  /// It may have been carried elsewhere: the next fix is believed whole.
  void doubt();

  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Fixes of localisation in a row.
  [[nodiscard]] int fixes() const { return fixes_; }
  /// By how much the gait turns the robot while it moves, as learnt [rad/m].
  [[nodiscard]] double drift() const { return drift_rad_per_m_; }

 private:
  static constexpr std::size_t kPast = 16;
  [[nodiscard]] const Pose& at(double stamp_s, double now_s) const;
  void correctHeading(double off_rad);

  BeliefSettings settings_;
  Pose pose_;
  std::array<Pose, kPast> past_{};  // a ring; the newest at newest_
  std::size_t newest_ = 0;
  int fixes_ = 0;
  double weight_ = 1.0;  // of what it believed before those, in fixes
  int headings_ = 0;
  double moved_m_ = 0.0;  // since the last correction
  double drift_rad_per_m_ = 0.0;
};

}  // namespace underway
