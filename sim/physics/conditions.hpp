#pragma once

#include <cstdint>

#include "sim/physics/scene.hpp"

namespace underway::physics {

/// What differs from one run to the next, drawn from a seed.
struct Conditions {
  double friction = 0.7;
  double servo_error_rad = 0.0;  ///< every servo's zero is off by up to this, to either side [rad]
  double start_error_m = 0.0;    ///< the start is off by up to this, along x and y [m]
  double start_error_rad = 0.0;  ///< and its heading by up to this [rad]
  double imu_drift_radps = 0.0;  ///< the IMU's heading runs off by up to this, to either side [rad/s]
  std::uint64_t seed = 0;        ///< of the errors
};

/// Friction between 0.4 and 1.0, spread evenly over 20 seeds that follow each other; servos' zeros off by up
/// to 0.3 degrees; the start off by up to 2 mm and 0.3 degrees; the IMU off by up to 0.5 degrees a minute.
[[nodiscard]] Conditions conditionsOf(std::uint64_t seed);

}  // namespace underway::physics
