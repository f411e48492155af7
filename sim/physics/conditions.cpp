#include "sim/physics/conditions.hpp"

namespace underway::physics {

Conditions conditionsOf(std::uint64_t seed) {
  constexpr std::uint64_t kSteps = 20;
  constexpr double kLeast = 0.4;
  constexpr double kMost = 1.0;
  const double share = static_cast<double>(seed % kSteps) / (kSteps - 1);
  return {.friction = kLeast + share * (kMost - kLeast),
          .servo_error_rad = 0.005,
          .start_error_m = 0.002,
          .start_error_rad = 0.005,
          .imu_drift_radps = 0.00015,
          .seed = seed};
}

}  // namespace underway::physics
