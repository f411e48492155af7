#pragma once

#include <memory>

#include "local/command.hpp"
#include "local/godzila/heading.hpp"
#include "local/godzila/settings.hpp"
#include "local/hold.hpp"
#include "local/lane.hpp"
#include "local/senses.hpp"
#include "planner/plan.hpp"

namespace underway {

struct FollowSettings {
  GodzilaSettings godzila;
  HoldSettings hold;
  double roomy_m = 0.25;      ///< with this much clearance GODZILA drives; with less, the plan [m]
  double ahead_m = 0.6;       ///< the intermediate goal is so far ahead along the plan [m]
  double slow_share = 0.6;    ///< of the mode's speed, on the plan's authority
  double ending_m = 0.35;     ///< before a segment's end it goes exactly [m]
  double reached_m = 0.006;   ///< a translation's end [m]
  double reached_rad = 0.01;  ///< a turn's end [rad]
};

/// Goes along the standing segments of a plan: translations and turns.
///
/// Where the segment's clearance leaves room, GODZILA drives, towards intermediate goals along the plan, in
/// the sense's own direction: (3.18) in its sideways form. Where it is tighter than GODZILA goes by itself,
/// the segment is followed exactly and slowly, because the plan's certificate says that it is free.
class Follow {
 public:
  Follow(const FollowSettings& settings, std::shared_ptr<const Robot> robot, const Beams& beams);

  /// A segment begins, in the world of a checker.
  void begin(const Segment& segment, const Pose& at, const Checker& checker);
  /// One tick along it. `shift_m` moves the intermediate goals to the left, round something in the way.
  [[nodiscard]] Velocity along(const Segment& segment, const Pose& at, const Scan* scan, double shift_m);
  [[nodiscard]] bool isDone(const Segment& segment, const Pose& at) const;

  /// Whether it is so far from the segment that what the plan says of the way back to it is nothing: it was
  /// carried elsewhere, or the plan begins elsewhere.
  [[nodiscard]] bool isAstray(const Segment& segment, const Pose& at) const;
  /// How far from the segment's line GODZILA may lead the turning body [m]; 0 if the plan drives.
  [[nodiscard]] double allowance() const { return allowance_m_; }
  /// Along a translation [m], or turned [rad], so far.
  [[nodiscard]] double progress(const Segment& segment, const Pose& at) const;

 private:
  [[nodiscard]] double allowanceOn(const Segment& segment, const Checker& checker) const;
  [[nodiscard]] Velocity turnOn(const Motion& motion, const Pose& at, double tolerance_m) const;
  [[nodiscard]] Velocity byPlan(const Segment& segment, const Pose& at) const;
  [[nodiscard]] Velocity byGodzila(const Segment& segment, const Pose& at, const Scan& scan,
                                   double shift_m) const;

  FollowSettings settings_;
  std::shared_ptr<const Robot> robot_;
  SpeedLimits limits_;
  HeadingOptimum optimum_;
  double allowance_m_ = 0.0;
  double turned_rad_ = 0.0;  // since the turn began
  double last_yaw_ = 0.0;
};

}  // namespace underway
