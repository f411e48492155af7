#pragma once

#include <cstdint>
#include <random>

namespace underway::gait::test {

/// The same seed draws the same on any machine.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1.0p-53;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace underway::gait::test
