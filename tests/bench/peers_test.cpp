#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "bench/peers/forked.hpp"
#include "bench/peers/peer.hpp"

namespace underway::bench {
namespace {

Task taskIn(double limit_s) {
  Mode walk;
  walk.name = "walk";
  walk.body_m = {{-0.13, 0.13}, {-0.195, 0.195}, {0.0, 0.5}};
  walk.speed_mps = {0.1, 0.1, 0.1, 0.1};
  walk.turn_speed_radps = 0.5;
  const Obstacle wall{"wall", OrientedBox{{2.0, 1.0, 0.5}, {0.1, 2.0, 1.0}, {}}};
  Task task;
  task.world = std::make_shared<World>(*World::make("room", {{0.0, 0.0, 0.0}, 4.0, 3.0}, 0.0, {wall}));
  task.robot = std::make_shared<Robot>(*checkedRobot({"walker", 0.0, {walk}, {}, {}}));
  task.request = {{1.0, 1.0, 0.0}, 0, {3.0, 1.0}, 0.0, 0, Policy::kFastest};
  task.limit_s = limit_s;
  return task;
}

TEST(Peers, AllFindTheWayRoundAWall) {
  for (const std::string& dut : peerNames()) {
    const auto run = runPeer(dut, taskIn(0.4));
    ASSERT_FALSE(run.progress.empty()) << dut;
    EXPECT_GT(run.progress.back().cost_s, 20.0) << dut << ": straight through the wall it is 20 s";
    for (std::size_t i = 1; i < run.progress.size(); ++i) {
      EXPECT_LT(run.progress[i].cost_s, run.progress[i - 1].cost_s) << dut;
      EXPECT_GE(run.progress[i].time_s, run.progress[i - 1].time_s) << dut;
    }
  }
}

TEST(Peers, HaveNoPlanFromAStartInTheWall) {
  Task task = taskIn(0.1);
  task.request.start.x = 2.0;
  EXPECT_TRUE(runPeer("PRM", task).progress.empty());
}

TEST(Forked, EndsWhatDoesNotKeepToItsLimit) {
  const auto run = runForked(0.1, [](const auto& tell) {
    tell({0.01, 5.0});
    std::this_thread::sleep_for(std::chrono::minutes(1));
  });
  EXPECT_TRUE(run.was_killed);
  EXPECT_LT(run.took_s, 5.0);
  ASSERT_EQ(run.progress.size(), 1U) << "what it told before counts";
}

TEST(Forked, TakesOnlyWhatIsBetter) {
  const auto run = runForked(1.0, [](const auto& tell) {
    tell({0.1, 5.0});
    tell({0.2, 6.0});
    tell({0.3, 4.0});
  });
  EXPECT_FALSE(run.was_killed);
  EXPECT_EQ(run.progress.size(), 2U);
}

}  // namespace
}  // namespace underway::bench
