#include "geometry/flatten.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

Vec3 pointIn(test::RandomWorld& random, const OrientedBox& box) {
  const Rotation rows = rotation(box);
  const Vec3 local{random.between(-0.5, 0.5) * box.size_m.x, random.between(-0.5, 0.5) * box.size_m.y,
                   random.between(-0.5, 0.5) * box.size_m.z};
  const auto along = [&](const Vec3& row) { return row.x * local.x + row.y * local.y + row.z * local.z; };
  return {box.center_m.x + along(rows[0]), box.center_m.y + along(rows[1]), box.center_m.z + along(rows[2])};
}

TEST(Flattened, HoldsTheShadowOfEveryPointOfTheBoxInTheSlabAndNoCornerThatIsNone) {
  test::RandomWorld random(1);
  for (int i = 0; i < 400; ++i) {
    const OrientedBox box = random.box(true);
    const Range slab{0.005, random.between(0.1, 0.6)};
    const std::vector<Point> dut = flattened(box, slab);
    std::vector<double> nearest(dut.size(), 1e9);
    for (int k = 0; k < 3000; ++k) {
      const Vec3 p = pointIn(random, box);
      if (p.z < slab.min || p.z > slab.max) continue;
      ASSERT_FALSE(dut.empty());
      ASSERT_LT(distanceTo(dut, {p.x, p.y}), 1e-12);
    }
    // Each corner is the shadow of a point of the box between the slab's faces: with z free it has a height
    // there.
    for (const Point corner : dut) {
      bool found = false;
      for (int k = 0; k <= 200 && !found; ++k) {
        const double z = slab.min + (slab.max - slab.min) * k / 200;
        const Rotation rows = rotation(box);
        const Vec3 d{corner.x - box.center_m.x, corner.y - box.center_m.y, z - box.center_m.z};
        const double lx = rows[0].x * d.x + rows[1].x * d.y + rows[2].x * d.z;
        const double ly = rows[0].y * d.x + rows[1].y * d.y + rows[2].y * d.z;
        const double lz = rows[0].z * d.x + rows[1].z * d.y + rows[2].z * d.z;
        found = std::abs(lx) <= 0.5 * box.size_m.x + 5e-3 && std::abs(ly) <= 0.5 * box.size_m.y + 5e-3 &&
                std::abs(lz) <= 0.5 * box.size_m.z + 5e-3;
      }
      ASSERT_TRUE(found) << "case " << i;
    }
  }
}

TEST(Flattened, TouchingTheSlabCountsAndMissingItLeavesNothing) {
  const OrientedBox table{{0, 0, 0.5}, {1, 1, 0.5}, {}};
  EXPECT_TRUE(flattened(table, {0.005, 0.249}).empty());
  EXPECT_EQ(flattened(table, {0.005, 0.25}).size(), 4U);
  EXPECT_TRUE(flattened(table, {0.751, 1.0}).empty());
}

TEST(Flattened, OfALeaningBoardOnlyTheLowPartBlocksTheCrawl) {
  // A board leaning at 45 degrees from the floor at x = 0 up to x = 1: below .21 m it reaches to x of about
  // .21.
  const OrientedBox board{{0.5, 0.0, 0.5}, {1.4142, 1.0, 0.001}, {0.0, -0.7853981633974483, 0.0}};
  double furthest = -1.0;
  for (const Point corner : flattened(board, {0.005, 0.21})) furthest = std::max(furthest, corner.x);
  EXPECT_NEAR(furthest, 0.21, 2e-3);
}

TEST(LowestAbove, OfATableTopIsItsUndersideAndNothingBesideIt) {
  const OrientedBox top{{0, 0, 0.72}, {1, 1, 0.04}, {}};
  const std::vector<Point> under{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  const std::vector<Point> beside{{0.6, -0.1}, {0.8, -0.1}, {0.8, 0.1}, {0.6, 0.1}};
  EXPECT_NEAR(*lowestAbove(top, under, 0.585), 0.70, 1e-12);
  EXPECT_FALSE(lowestAbove(top, beside, 0.585).has_value());
  EXPECT_FALSE(lowestAbove(top, under, 0.75).has_value());
}

TEST(LowestAbove, OfTiltedBoxesEqualsTheLowestOfManyPoints) {
  test::RandomWorld random(3);
  const std::vector<Point> area{{1.0, 1.0}, {2.5, 1.0}, {2.5, 2.5}, {1.0, 2.5}};
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    OrientedBox box = random.box(true);
    box.center_m.z = random.between(0.9, 1.5);  // clear of the height over the area, as the function demands
    box.size_m = {0.5, 0.5, 0.1};
    const auto dut = lowestAbove(box, area, 0.5);
    double lowest = 1e9;
    for (int k = 0; k < 20000; ++k) {
      const Vec3 p = pointIn(random, box);
      if (p.x >= 1.0 && p.x <= 2.5 && p.y >= 1.0 && p.y <= 2.5 && p.z >= 0.5) lowest = std::min(lowest, p.z);
    }
    if (lowest > 1e8) continue;
    ++hits;
    ASSERT_TRUE(dut.has_value());
    ASSERT_LE(*dut, lowest + 1e-12);
    ASSERT_GE(*dut, lowest - 0.05);
  }
  EXPECT_GT(hits, 50);
}

}  // namespace
}  // namespace underway
