#pragma once

namespace underway::gait {

/// Where a robot is beside the line it should crawl on.
struct OffLine {
  double heading_rad = 0.0;  ///< against the line's, to the left
  double left_m = 0.0;       ///< of the line
};

/// How a crawl is steered: the body turns a little over its planted toes and elbows in each push
/// (CrawlGait::turn_rad), by different trajectories left and right. The figures are those of
/// cruiseGait() in MuJoCo (`underway bench physics`).
struct Steering {
  double gain = 1.5;               ///< turn asked for, by error of heading; half of it comes about
  double return_m = 0.5;           ///< the line is aimed at this far ahead [m]
  double aim_rad = 0.035;          ///< but never more than this across it [rad]
  double most_turn_rad = 0.087;    ///< what the joints leave room for, to either side [rad]
  double advance_m = 0.090;        ///< of a cycle [m]
  double aside_m_per_rad = 0.041;  ///< a turn's push also goes aside by this [m/rad]
};

/// The turn of the next push that leads back to the line [rad].
[[nodiscard]] double turnTowards(const OffLine& off, const Steering& steering = {});

/// Where the robot is beside the line after a cycle, from its heading alone: what a robot knows that sees
/// nothing. `heading_rad`, as an IMU tells it, against the line's; `turn_rad` of the cycle's push.
[[nodiscard]] OffLine reckon(const OffLine& before, double heading_rad, double turn_rad,
                             const Steering& steering = {});

}  // namespace underway::gait
