#pragma once

#include <span>
#include <string>

#include "local/scan.hpp"

namespace underway {

/// A planar lidar as it stands in the body frame.
struct LidarMount {
  Pose at;               ///< of the lidar's frame, in the mode's body frame
  double nearest_m = 0;  ///< what is nearer is no measurement [m]
};

/// What a lidar saw with whatever beams it has, as the beams that the local layer is made for (Beams{}), from
/// the body frame's origin. An infinite beam met nothing in its range. A beam that measured nothing
/// (NaN, minus infinity, zero, too near) tells nothing, nor do those where the lidar does not look:
/// kNotLooked. `ranges_m` has as many as beams.count.
[[nodiscard]] Scan asStandardScan(const Beams& beams, std::span<const float> ranges_m, double stamp_s,
                                  const LidarMount& mount = {});

/// What is wrong with some beams, naming the field; empty if nothing is.
[[nodiscard]] std::string faultOf(const Beams& beams);

}  // namespace underway
