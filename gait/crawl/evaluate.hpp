#pragma once

#include <array>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/push.hpp"
#include "gait/crawl/torque.hpp"

namespace underway::gait {

/// What may not happen in a push (Brooks 2017, (4.30)-(4.34); Table 6), and two bounds without which an
/// optimum arches its back and jumps at the start: the height of the joints, and the rate of alpha.
struct PushLimits {
  double knee_least_rad = radians(-5.0);
  double knee_most_rad = radians(45.0);
  double hip_least_rad = radians(-30.0);
  double hip_most_rad = radians(27.7);       ///< Table 6 ends at 15, which leaves out the nominal gait
  double alpha_least_rad = radians(-90.01);  ///< the last digit of a rounded -90
  double alpha_most_rad = radians(-29.99);
  double hip_height_least_m =
      0.010;                     ///< z of the hip; the thesis' 40 mm would refuse the nominal gait itself
  double height_most_m = 0.110;  ///< of every joint of the chain
  double alpha_rate_most = 3.0;  ///< times its mean rate; it never rises
};

/// What the crawl is played on, and how.
struct PushSetting {
  double toe_to_elbow_m = 0.43;
  double spread_m = 0.0565;
  double push_s = 1.0;
  PushLimits limits;
  InternalForce force;
};

/// Figures of a push.
struct PushFigures {
  /// 0 when all limits are kept, else how much and how long they are not: a sum over the push of squared
  /// excess, in units of 0.1 rad, 10 mm, or the mean rate; 1 and more for an infeasible pose.
  double violation = 0.0;
  std::array<double, 4> torque_nm2{};  ///< mean squares: ankle, knee, hip, shoulder [N^2 m^2]
  double peak_nm = 0.0;                ///< the largest torque of all
  double highest_m = 0.0;              ///< of the chain's joints
  double hip_lowest_m = 0.0;
  double stroke_m = 0.0;    ///< of the shoulder, over the floor
  double back_rad2 = 0.0;   ///< mean square of the back's slope
  double head_m2 = 0.0;     ///< mean square of the head's way off a straight and even one
  double shortest_s = 0.0;  ///< time for the push at which a joint of the chain is as fast as it can be
};

/// Samples the push at 41 phases. Never fails: an infeasible pose is a violation. Pure.
[[nodiscard]] PushFigures evaluate(const Crawler& crawler, const ChainMasses& masses, const PushShape& push,
                                   const PushSetting& setting);

/// What is to be small.
enum class Aim {
  kTorque,      ///< the paper's weights: 1, 1, 1, 5
  kEvenTorque,  ///< 1, 1, 1, 1
  kSpeed,       ///< the time a push takes at least
  kLevelBack,   ///< the back's slope
  kSteadyHead,  ///< the head's way off a straight and even one
};
/// sum w_i tau_i^2 [N^2 m^2], the mean over the push.
[[nodiscard]] double torqueCost(const PushFigures& figures, const std::array<double, 4>& weights);
inline constexpr std::array<double, 4> kPaperWeights{1.0, 1.0, 1.0, 5.0};
inline constexpr std::array<double, 4> kEvenWeights{1.0, 1.0, 1.0, 1.0};

/// The aim's own cost: [N^2 m^2], [s], [rad^2] or [cm^2]. The last three also count torque a little, so that
/// a gait that is level is not wasteful.
[[nodiscard]] double costOf(const PushFigures& figures, Aim aim);

}  // namespace underway::gait
