#include "local/scan.hpp"

#include <gtest/gtest.h>

namespace underway {
namespace {

TEST(Beams, AreEachVisitedOnceWithTheirDirection) {
  for (const Beams& beams :
       {Beams{}, Beams{257, -0.75, 1.5 / 256.0}, Beams{3, 1.0, 0.1}, Beams{0, 0.0, 0.1}}) {
    constexpr double kTurned_rad = 0.7;
    std::size_t next = 0;
    forEachBeam(beams, kTurned_rad, [&](std::size_t i, Point direction) {
      ASSERT_EQ(i, next++);
      ASSERT_NEAR(direction.x, std::cos(beams.bearing(i) + kTurned_rad), 1e-12);
      ASSERT_NEAR(direction.y, std::sin(beams.bearing(i) + kTurned_rad), 1e-12);
    });
    EXPECT_EQ(next, beams.count);
  }
}

TEST(Beams, AreAllAmongEveryNth) {
  const Beams all;
  std::size_t count = 0;
  for (std::size_t first = 0; first < 16; ++first) {
    const Beams some = all.every(16, first);
    count += some.count;
    for (std::size_t i = 0; i < some.count; ++i)
      ASSERT_NEAR(some.bearing(i), all.bearing(first + 16 * i), 1e-12);
  }
  EXPECT_EQ(count, all.count);
  EXPECT_EQ((Beams{3, 0.0, 0.1}).every(16, 5).count, 0U);
}

}  // namespace
}  // namespace underway
