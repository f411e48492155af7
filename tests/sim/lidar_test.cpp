#include "sim/lidar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/geometry/random_world.hpp"

namespace underway::sim {
namespace {

std::shared_ptr<const World> worldOf(std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(
      *World::make("room", {{-5, -5, 0}, 10, 10}, 0.0, std::move(obstacles)));
}

/// The slow and obvious way: a ray against the four planes of an upright box.
double alongRay(const OrientedBox& box, const Pose& from, double bearing) {
  const double c = std::cos(box.rpy_rad.z);
  const double s = std::sin(box.rpy_rad.z);
  const double dx = from.x - box.center_m.x;
  const double dy = from.y - box.center_m.y;
  const double angle = from.yaw + bearing - box.rpy_rad.z;
  const double origin[2] = {c * dx + s * dy, c * dy - s * dx};
  const double way[2] = {std::cos(angle), std::sin(angle)};
  const double half[2] = {0.5 * box.size_m.x, 0.5 * box.size_m.y};
  double in = 0.0;
  double out = 1e9;
  for (int k = 0; k < 2; ++k) {
    const double a = (-half[k] - origin[k]) / way[k];
    const double b = (half[k] - origin[k]) / way[k];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in <= out ? in : 1e9;
}

TEST(Lidar, SeesWhatARayAgainstEachBoxSays) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    test::RandomWorld random(seed);
    std::vector<Obstacle> boxes;
    for (int i = 0; i < 12; ++i) {
      Obstacle box{"box_" + std::to_string(i), random.box(false)};
      box.box.center_m.z = 0.3;
      boxes.push_back(box);
    }
    const Lidar dut(*worldOf(boxes), {});
    const Pose from = random.pose();
    const bool is_inside = std::any_of(
        boxes.begin(), boxes.end(), [&](const Obstacle& box) { return alongRay(box.box, from, 0.1) == 0.0; });
    if (is_inside) continue;
    Scan scan;
    dut.look(from, scan);
    for (std::size_t i = 0; i < scan.beams.count; ++i) {
      double truth = 1e9;
      for (const Obstacle& box : boxes)
        truth = std::min(truth, alongRay(box.box, from, scan.beams.bearing(i)));
      if (truth > 5.59 || truth < 0.03) continue;
      ASSERT_NEAR(scan.ranges_m[i], truth, 1e-5) << "seed " << seed << ", beam " << i;
    }
  }
}

TEST(Lidar, IsBlindToWhatDoesNotCrossItsPlane) {
  const Obstacle above{"top", {{1.0, 0.0, 0.5}, {0.4, 2.0, 0.1}, {}}};
  const Obstacle below{"sill", {{1.0, 0.0, 0.1}, {0.4, 2.0, 0.2}, {}}};
  Scan scan;
  Lidar(*worldOf({above, below}), {}).look({0, 0, 0}, scan);
  EXPECT_EQ(std::count(scan.ranges_m.begin(), scan.ranges_m.end(), Scan::kNothing),
            static_cast<std::ptrdiff_t>(scan.beams.count));
  LidarSettings depth;
  depth.heights_m = {0.02, 0.585};
  Lidar(*worldOf({above}), depth).look({0, 0, 0}, scan);
  EXPECT_NEAR(scan.ranges_m[scan.beams.count / 2], 0.8, 1e-6);
}

TEST(Lidar, TellsNothingBeyondItsRange) {
  const Obstacle wall{"wall", {{4.0, 0.0, 0.5}, {0.2, 8.0, 1.0}, {}}};
  LidarSettings settings;
  settings.farthest_m = 3.0;
  Scan scan;
  Lidar(*worldOf({wall}), settings).look({0, 0, 0}, scan);
  EXPECT_EQ(scan.ranges_m[scan.beams.count / 2], Scan::kNothing);
}

TEST(Lidar, HasTheNoiseThatItSays) {
  const Obstacle near{"near", {{1.0, 0.0, 0.5}, {0.4, 0.2, 1.0}, {}}};
  const Obstacle far{"far", {{-4.0, 0.0, 0.5}, {0.2, 8.0, 1.0}, {}}};
  const Lidar dut(*worldOf({near, far}), {});
  std::mt19937_64 random(1);
  const auto sigmaAt = [&](const Pose& from, double truth) {
    double squares = 0.0;
    for (int k = 0; k < 2000; ++k) {
      Scan scan;
      dut.look(from, scan, random);
      const double off = scan.ranges_m[scan.beams.count / 2] - truth;
      squares += off * off;
    }
    return std::sqrt(squares / 2000);
  };
  EXPECT_NEAR(sigmaAt({0.0, 0.0, 0.0}, 0.8), 0.010, 0.001);
  EXPECT_NEAR(sigmaAt({0.0, 3.0, 3.14159265}, 3.9), 0.039, 0.004);
}

}  // namespace
}  // namespace underway::sim
