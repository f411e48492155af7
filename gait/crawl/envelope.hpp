#pragma once

#include <Eigen/Core>

#include "gait/crawl/gait.hpp"
#include "gait/skeleton.hpp"

namespace underway::gait {

/// The room a motion takes: what a robot file says of a mode or a switch, computed from the motion and the
/// robot's shape at rest (gait/rest.hpp). Levels and even floors; physics has the last word.
struct Envelope {
  Eigen::Vector3d low;     ///< corner of the box that the whole robot sweeps, in the body frame [m]
  Eigen::Vector3d high;    ///< the opposite one
  double advance_m = 0.0;  ///< of the pose, along x
  double duration_s = 0.0;
  double least_margin_m = 0.0;  ///< of the centre of mass inside its support
};

/// One cycle of a crawl that has been going on, in the body frame of the crawl: on the floor below the hip
/// joints at the start of the push. Between two cycles the pose moves by `advance_m`. Errors: those of
/// crawlMotion.
[[nodiscard]] GaitExpected<Envelope> crawlEnvelope(const Skeleton& skeleton, const Crawler& crawler,
                                                   const CrawlGait& gait);

/// How the robot is when a switch begins or ends.
enum class Stance {
  kStanding,  ///< the body frame is below the middle of the ankles
  kLying,     ///< the body frame is below the middle of the hips
};
/// A switch, in the body frame it begins in.
[[nodiscard]] Envelope switchEnvelope(const Skeleton& skeleton, const JointTable& motion, Stance from,
                                      Stance to);

}  // namespace underway::gait
