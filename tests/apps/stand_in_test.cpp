#include "apps/stand_in.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/server/robot/robot_fixture.hpp"

namespace underway {
namespace {

const Command kAhead{{0.05, 0.0, 0.0}, std::nullopt};

TEST(CommandWatchdog, holdsACommandForHalfASecondAndNoLonger) {
  CommandWatchdog dut;
  EXPECT_TRUE(dut.isSilent(1));
  EXPECT_EQ(dut.at(1), Command{});
  dut.hear(3, kAhead);
  for (std::uint64_t tick = 3; tick < 8; ++tick) EXPECT_EQ(dut.at(tick), kAhead) << tick;
  EXPECT_EQ(dut.at(8), Command{});
  EXPECT_TRUE(dut.isSilent(8));
  dut.hear(9, kAhead);
  EXPECT_EQ(dut.at(13), kAhead);
}

struct StandInTest : testing::Test {
  std::shared_ptr<const Domain> domain = fixture::openDomain();
  std::unique_ptr<DriverEnd> driver = openDriverEnd(*domain, "nao", test::nao()).value();
  std::shared_ptr<const World> world =
      std::make_shared<const World>(*World::make("room", {{0, 0, 0}, 5, 3}, 0.0, {}));
  sim::SimulatedRobot body{world, test::nao(), {0.6, 0.6, 0.0}, 0, 1};
};

TEST_F(StandInTest, standsStillWhenTheCommandsEnd) {
  StandIn dut(body, openRobotEnd(*domain, "nao", test::nao()).value(), {false, 20.0});
  std::atomic<bool> has_heard = false;
  std::jthread commander([&](const std::stop_token& stop) {  // until one is heard, then never again
    while (!has_heard && !stop.stop_requested()) {
      EXPECT_TRUE(driver->send(0, kAhead));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  std::stop_source stop;
  std::uint64_t heard = 0;
  std::uint64_t silent = 0;
  Pose at_rest;
  ASSERT_TRUE(dut.live(stop.get_token(), [&](std::uint64_t, const sim::SimulatedRobot& seen, bool is_silent) {
    if (!is_silent) has_heard = true, ++heard;
    if (!has_heard || !is_silent) return;
    if (++silent == 1) at_rest = seen.truth().pose;
    if (silent == 20) stop.request_stop();
  }));
  EXPECT_GE(heard, CommandWatchdog::kLongest_ticks);
  EXPECT_GT(body.truth().moved_m, 0.0);
  EXPECT_EQ(body.truth().pose, at_rest);
  EXPECT_LE(body.truth().moved_m, 0.1 * 0.0501 * static_cast<double>(heard));
}

TEST_F(StandInTest, inStepTimeWaitsForTheAnswers) {
  std::stop_source stop;
  std::jthread living([&] {
    StandIn dut(body, openRobotEnd(*domain, "nao", test::nao()).value(), {true, 0.0});
    EXPECT_TRUE(dut.live(stop.get_token()));
  });
  for (std::uint64_t tick = 1; tick <= 30;) {
    const auto heard = driver->hear(fixture::inTime()).value();
    ASSERT_TRUE(heard);
    ASSERT_TRUE(heard->tick == tick || heard->tick + 1 == tick) << heard->tick;  // told again, never ahead
    if (heard->tick + 1 == tick) {
      ASSERT_TRUE(driver->send(heard->tick, kAhead));
    }
    if (heard->tick != tick) continue;
    EXPECT_NEAR(heard->rest.now_s, 0.1 * static_cast<double>(tick - 1), 1e-9);
    ASSERT_TRUE(driver->send(tick, kAhead));
    ++tick;
  }
  stop.request_stop();
  living.join();
  EXPECT_NEAR(body.truth().moved_m, 30 * 0.005, 0.0051);  // the last answer may come when it has ended
}

}  // namespace
}  // namespace underway
