#include "local/drivable.hpp"

#include <gtest/gtest.h>

#include "geometry/map.hpp"
#include "tests/planner/fixture.hpp"

namespace underway {
namespace {

TEST(Drivable, IsNao) { EXPECT_TRUE(checkDrivable(*test::nao())); }

TEST(Drivable, IsNoRobotThatTurnsWhileItStoops) {
  const auto biped = readRobot(UNDERWAY_SOURCE_DIR "/robots/tall_biped.yaml");
  ASSERT_TRUE(biped);
  const auto drivable = checkDrivable(*biped);
  ASSERT_FALSE(drivable);
  EXPECT_EQ(drivable.error().code, ErrorCode::kInvalidRobot);
  EXPECT_NE(drivable.error().message.find("low mode"), std::string::npos);
}

TEST(Drivable, IsNoRobotThatCrawlsBackwards) {
  Robot robot = *test::nao();
  for (Mode& mode : robot.modes)
    if (mode.body_m.z.max < robot.modes.front().body_m.z.max)
      mode.speed_mps[static_cast<std::size_t>(Sense::kBackward)] = 0.01;
  EXPECT_FALSE(checkDrivable(robot));
}

}  // namespace
}  // namespace underway
