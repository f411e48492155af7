#include <gtest/gtest.h>

#include "gait/crawl/envelope.hpp"
#include "gait/nao.hpp"
#include "geometry/map.hpp"

/// robots/nao.yaml against the gait that the planner's crawl stands for. Switches are held against physics
/// (tests/sim/physics).
namespace underway {
namespace {

constexpr double kRoom_m = 0.04;  ///< what the file may add to the gait's own room, on each side

struct Both {
  Mode mode;                ///< as the file has it
  gait::Envelope envelope;  ///< as the gait has it
};

Both cruise() {
  const auto robot = readRobot(UNDERWAY_SOURCE_DIR "/robots/nao.yaml");
  EXPECT_TRUE(robot) << robot.error().message;
  const auto envelope = gait::crawlEnvelope(gait::nao(), gait::naoCrawler(), gait::cruiseGait());
  EXPECT_TRUE(envelope) << envelope.error().message;
  return {robot->modes.at(*robot->findMode("crawl")), *envelope};
}

TEST(NaoFile, CrawlBodyEnclosesTheGaitAndLittleMore) {
  const auto [mode, room] = cruise();
  for (const auto& [axis, range] : {std::pair{0, mode.body_m.x}, {1, mode.body_m.y}}) {
    EXPECT_LE(range.min, room.low[axis]) << "axis " << axis;
    EXPECT_GE(range.max, room.high[axis]) << "axis " << axis;
    EXPECT_GE(range.min, room.low[axis] - kRoom_m) << "axis " << axis;
    EXPECT_LE(range.max, room.high[axis] + kRoom_m) << "axis " << axis;
  }
  EXPECT_EQ(mode.body_m.z.min, 0.0);
  EXPECT_GE(mode.body_m.z.max, room.high.z());
  EXPECT_LE(mode.body_m.z.max, room.high.z() + 0.01);
}

TEST(NaoFile, CrawlIsAsFastAsTheGait) {
  const auto [mode, room] = cruise();
  const double speed_mps = room.advance_m / room.duration_s;
  // At rest the robot advances a little less than in motion.
  EXPECT_NEAR(mode.speed(Sense::kForward), speed_mps, 0.15 * speed_mps);
  EXPECT_FALSE(mode.canTurn());
  EXPECT_FALSE(mode.canMove(Sense::kBackward));
}

}  // namespace
}  // namespace underway
