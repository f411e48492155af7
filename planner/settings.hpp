#pragma once

#include <cstdint>

namespace underway {

/// What fixes a roadmap, besides the world, the robot and the number of batches.
struct GrowthSettings {
  std::uint64_t seed = 1;
  double sites_per_m2 =
      3.0;  ///< positions sampled per square metre of free floor before the first query [1/m2]
};

}  // namespace underway
