#include "local/godzila/trap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace underway {
namespace {

const TrapSettings kSettings{10.0, 0.3, 0.1};  // a hundred ticks

/// The first tick at which a way is called a trap; 0 if none is.
template <class Way>
int trappedAt(const Way& way, int ticks) {
  TrapDetector dut(kSettings);
  for (int k = 1; k <= ticks; ++k)
    if (dut.watch(way(0.1 * k))) return k;
  return 0;
}

TEST(TrapDetector, CallsStandingStillATrapWhenItsWindowIsFull) {
  EXPECT_EQ(trappedAt([](double) { return Point{1.0, 2.0}; }, 200), 100);
}

TEST(TrapDetector, CallsRockingToAndFroATrap) {
  EXPECT_GT(trappedAt([](double t) { return Point{0.5 * std::sin(2.0 * t), 0.0}; }, 400), 0);
}

TEST(TrapDetector, CallsCirclesATrap) {
  EXPECT_GT(trappedAt([](double t) { return Point{0.1 * std::cos(t), 0.1 * std::sin(t)}; }, 400), 0);
}

TEST(TrapDetector, LetsARobotPassThatGoesSlowly) {
  EXPECT_EQ(trappedAt([](double t) { return Point{0.04 * t, 0.0}; }, 2000), 0);
}

TEST(TrapDetector, ForgetsWhenItIsReset) {
  TrapDetector dut(kSettings);
  for (int k = 0; k < 99; ++k) EXPECT_FALSE(dut.watch({}));
  dut.reset();
  for (int k = 0; k < 99; ++k) EXPECT_FALSE(dut.watch({}));
  EXPECT_TRUE(dut.watch({}));
}

}  // namespace
}  // namespace underway
