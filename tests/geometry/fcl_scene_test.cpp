#include "geometry/fcl_scene.hpp"

#include <gtest/gtest.h>

#include "tests/geometry/random_world.hpp"

namespace underway {
namespace {

std::shared_ptr<const Obstacles> obstaclesOf(const std::shared_ptr<const World>& world) {
  return {world, &world->obstacles()};
}

/// As many changes at a time as a scene carries beside its tree, or more, whether it was asked in between or
/// not.
TEST(FclScene, AnswersAfterChangesAsOneMadeAnew) {
  test::RandomWorld random(1);
  auto world = random.world(60);
  FclScene dut(obstaclesOf(world));
  for (int step = 0; step < 60; ++step) {
    for (int k = 0; k < 1 + random.oneOf(12); ++k) {
      const auto i = static_cast<std::size_t>(random.oneOf(static_cast<int>(world->obstacles().size())));
      const std::string id = world->obstacles()[i].id;
      const int what = random.oneOf(3);
      auto changed =
          what == 0 ? world->moved(id, random.box(true))
          : what == 1
              ? world->removed(id)
              : world->added({"new_" + std::to_string(step) + "_" + std::to_string(k), random.box(true)});
      ASSERT_TRUE(changed);
      world = std::make_shared<const World>(std::move(*changed));
    }
    dut = dut.changed(obstaclesOf(world));
    if (random.oneOf(2) == 0) continue;  // not asked: its trees are never made
    const FclScene fresh(obstaclesOf(world));
    for (int k = 0; k < 100; ++k) {
      const Prism body{random.pose(), {-0.2, 0.2}, {-0.2, 0.2}, {0.0, 0.5}};
      const auto footprint = body.footprint();
      Region region = Region::between(footprint[0], footprint[2]);
      region = region.joint(Region::between(footprint[1], footprint[3]));
      ASSERT_EQ(dut.shapesIn(region).comeWithin(body, 0.0), fresh.shapesIn(region).comeWithin(body, 0.0))
          << "step " << step;
    }
  }
}

}  // namespace
}  // namespace underway
