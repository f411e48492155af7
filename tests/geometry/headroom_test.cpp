#include "geometry/headroom.hpp"

#include <gtest/gtest.h>

#include "geometry/flatten.hpp"
#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

constexpr double kTop_m = 0.5;

TEST(Headroom, OverATurnIsTheLeastOverItsHeadings) {
  test::RandomWorld random(1);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<Obstacle> obstacles;
    for (int k = 0; k < 4; ++k) {
      OrientedBox box = random.box(true);
      box.center_m.z = random.between(1.0, 1.6);
      obstacles.push_back({"box_" + std::to_string(k), box});
    }
    std::optional<std::string> twin;
    const Layer hanging = Layer::hangingAbove(kTop_m, Obstacles(obstacles, twin));
    const Prism body{random.pose(), {-0.1, 0.6}, {-0.2, 0.2}, {0.0, kTop_m}};
    const double angle = random.between(-3.0, 3.0);
    std::optional<double> least;
    for (int k = 0; k <= 400; ++k) {
      Prism there = body;
      there.frame.yaw += angle * k / 400;
      if (const auto here = headroomBelow(hanging, there)) least = std::min(least.value_or(*here), *here);
    }
    const auto dut = headroomBelow(hanging, body, angle);
    if (least) {
      ++found;
      ASSERT_TRUE(dut);
      ASSERT_LE(*dut, *least + 1e-9) << "case " << i;
      ASSERT_GE(*dut, *least - 0.03) << "case " << i;  // a sample may miss what it reaches in between
    }
  }
  EXPECT_GT(found, 50);
}

TEST(Headroom, OverManyTurnsIsThatOverOne) {
  std::optional<std::string> twin;
  const Layer hanging = Layer::hangingAbove(
      kTop_m, Obstacles({{"board", {{0.3, 0, 1.2}, {1, 1, 0.1}, {0.4, 0.2, 0.0}}}}, twin));
  const Prism body{{0.0, 0.0, 0.0}, {-0.1, 0.6}, {-0.2, 0.2}, {0.0, kTop_m}};
  EXPECT_NEAR(*headroomBelow(hanging, body, 1e5), *headroomBelow(hanging, body, 6.3), 1e-3);
}

TEST(Headroom, BelowATableIsTheGapToItsUnderside) {
  std::optional<std::string> twin;
  const Layer hanging =
      Layer::hangingAbove(kTop_m, Obstacles({{"top", {{0, 0, 0.72}, {1, 1, 0.04}, {}}}}, twin));
  const Prism under{{0.2, 0.0, 0.0}, {-0.1, 0.1}, {-0.1, 0.1}, {0.0, kTop_m}};
  const Prism beside{{0.7, 0.0, 0.0}, {-0.1, 0.1}, {-0.1, 0.1}, {0.0, kTop_m}};
  EXPECT_NEAR(*headroomBelow(hanging, under), 0.2, 1e-12);
  EXPECT_NEAR(*headroomBelow(hanging, under, 1.0), 0.2, 1e-12);
  EXPECT_FALSE(headroomBelow(hanging, beside));
  EXPECT_FALSE(headroomBelow(hanging, beside, 1.0));
}

}  // namespace
}  // namespace underway
