#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bench/random_geometry.hpp"
#include "bench/reference.hpp"
#include "geometry/checker.hpp"
#include "tests/geometry/random_world.hpp"

// How far a body can turn, held against turns that are looked at one by one.
namespace underway {
namespace {

constexpr double kRevolution = 2.0 * std::numbers::pi;
constexpr double kBeyond_rad = 1e-5;
/// What only grazes the body is met for certain by a body that is this much larger [m].
constexpr double kGrazing_m = 1e-6;
/// What comes within nanometres may be said to touch.
constexpr double kContact_m = 1e-8;

std::shared_ptr<const World> worldOf(const Bounds& bounds, std::vector<Obstacle> obstacles) {
  return std::make_shared<const World>(*World::make("random", bounds, 0.0, std::move(obstacles)));
}

Motion turned(ModeId mode, const Pose& at, double angle_rad) {
  return turn(mode, at, angle_rad, normalizedAngle(at.yaw + angle_rad));
}

/// That turning as far as the room says is free and a little further is not.
void expectRoomIsTrue(const Checker& checker, ModeId mode, const Pose& at, double margin_m,
                      const TurningRoom& room, double graze_m) {
  for (const double side : {1.0, -1.0}) {
    const double way = side > 0.0 ? room.left_rad : room.right_rad;
    ASSERT_GE(way, 0.0);
    ASSERT_LE(way, kRevolution);
    ASSERT_TRUE(checker.isFree(turned(mode, at, side * way), margin_m - kContact_m))
        << "all of the room, " << side * way;
    ASSERT_TRUE(checker.isFree(turned(mode, at, side * 0.7 * way), margin_m - kContact_m))
        << "less, " << side * way;
    if (way + kBeyond_rad < kRevolution) {
      ASSERT_FALSE(checker.isFree(turned(mode, at, side * (way + kBeyond_rad)), margin_m + graze_m))
          << "more than the room, " << side * way;
    }
  }
}

TEST(TurningRoom, IsAsMuchAsIsFreeAndNoMore) {
  constexpr unsigned kSeed = 1;
  test::RandomWorld random(kSeed);
  const auto robot = bench::benchRobot();
  int limited = 0;
  for (int round = 0; round < 300; ++round) {
    const Checker dut(random.world(random.oneOf(12)), robot);
    for (int i = 0; i < 30; ++i) {
      const auto mode = static_cast<ModeId>(random.oneOf(3));
      const Pose at = random.pose();
      const double margin = random.oneOf(2) == 0 ? 0.0 : 0.02;
      if (!dut.isFree(stay(mode, at), margin)) continue;
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round << " case " << i);
      const TurningRoom room = dut.turningRoom(mode, at, margin);
      expectRoomIsTrue(dut, mode, at, margin, room, kGrazing_m);
      if (HasFatalFailure()) return;
      limited += room.left_rad < kRevolution ? 1 : 0;
    }
  }
  EXPECT_GT(limited, 300) << "too few cases in which there is anything to meet";
}

TEST(TurningRoom, IsTrueNanometresFromContact) {
  constexpr unsigned kSeed = 2;
  bench::RandomGeometry random(kSeed);
  const auto robot = bench::benchRobot();
  int cases = 0;
  for (int round = 0; round < 6000; ++round) {
    const auto obstacles = random.obstacles({0, 0}, 2);
    const auto mode = static_cast<ModeId>(random.oneOf(3));
    const Range slab = slabOf(*robot, stay(mode, {}), 0.0);
    const auto shadow = bench::reference::shadow(obstacles[0].box, slab);
    if (shadow.size() < 3) continue;
    Pose at = random.pose({0, 0});
    const auto footprint = sweptBox(*robot, stay(mode, at), slab).grown(0.02).footprint();
    const Point shift = random.toContact({footprint.begin(), footprint.end()}, shadow);
    at = {at.x + shift.x, at.y + shift.y, at.yaw};
    const Checker dut(worldOf({{-20, -20, 0}, 40, 40}, obstacles), robot);
    if (!dut.isFree(stay(mode, at))) continue;
    ++cases;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    expectRoomIsTrue(dut, mode, at, 0.02, dut.turningRoom(mode, at, 0.02), kGrazing_m);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(cases, 1000);
}

TEST(TurningRoom, EndsAtTheBoundsWhereverTheyAreTurned) {
  constexpr unsigned kSeed = 3;
  test::RandomWorld random(kSeed);
  const auto robot = bench::benchRobot();
  int limited = 0;
  for (int round = 0; round < 3000; ++round) {
    const Pose corner{random.between(-5, 5), random.between(-5, 5), random.angle()};
    const Bounds bounds{corner, random.between(0.4, 2.0), random.between(0.4, 2.0)};
    const Checker dut(worldOf(bounds, {}), robot);
    const auto mode = static_cast<ModeId>(random.oneOf(3));
    const Point at =
        transform(corner, {random.between(0.0, bounds.width_m), random.between(0.0, bounds.height_m)});
    const Pose pose{at.x, at.y, random.angle()};
    if (!dut.isFree(stay(mode, pose))) continue;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " round " << round);
    const TurningRoom room = dut.turningRoom(mode, pose, 0.02);
    expectRoomIsTrue(dut, mode, pose, 0.02, room, 0.0);
    if (HasFatalFailure()) return;
    limited += room.left_rad < kRevolution ? 1 : 0;
  }
  EXPECT_GT(limited, 300);
}

TEST(TurningRoom, IsNoneOutsideTheBoundsAndAllOfItInAnEmptyWorld) {
  const Checker dut(worldOf({{0, 0, 0}, 4, 4}, {}), bench::benchRobot());
  EXPECT_EQ(dut.turningRoom(0, {9, 9, 0}, 0.0).left_rad, 0.0);
  EXPECT_EQ(dut.turningRoom(0, {2, 2, 0}, 0.0).left_rad, kRevolution);
  EXPECT_EQ(dut.turningRoom(0, {2, 2, 0}, 0.0).right_rad, kRevolution);
}

}  // namespace
}  // namespace underway
