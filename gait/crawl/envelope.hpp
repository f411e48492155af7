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

}  // namespace underway::gait
