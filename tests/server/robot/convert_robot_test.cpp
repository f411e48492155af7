#include "server/robot/convert_robot.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <limits>

#include "tests/server/robot/robot_fixture.hpp"

namespace underway {
namespace {

using fixture::randomCommand;
using fixture::randomSenses;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t kSeeds = 200;

const Robot& nao() { return *test::nao(); }

TEST(ConvertSenses, arriveAsTheyWereTold) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const HeardSenses told = randomSenses(seed);
    const auto heard = fromWire(*toWire(told.tick, told.senses(), nao()), nao());
    ASSERT_TRUE(heard) << "seed " << seed << ": " << heard.error().message;
    fixture::expectSame(told, *heard, seed);
  }
}

TEST(ConvertSenses, ofAnotherLidarComeInTheBeamsOfTheLocalLayer) {
  HeardSenses told;
  told.scan = Scan{1.0, {90, -0.5, 1.0 / 89.0}, std::vector<float>(90, 1.5F)};
  const auto heard = fromWire(*toWire(1, told.senses(), nao()), nao());
  ASSERT_TRUE(heard && heard->scan);
  EXPECT_EQ(heard->scan->beams, Beams{});
  EXPECT_EQ(heard->scan->ranges_m.size(), Beams{}.count);
  EXPECT_FLOAT_EQ(heard->scan->ranges_m[341], 1.5F);
}

TEST(ConvertSenses, areRefusedByFieldWhenAnythingIsOutOfRange) {
  HeardSenses full;
  full.scan = Scan{0.0, Beams{}, std::vector<float>(Beams{}.count, 1.0F)};
  full.depth = full.scan;
  full.rest.pose = PoseEstimate{};
  full.rest.heading_rad = 0.0;
  const std::pair<const char*, void (*)(underway_Senses&)> cases[] = {
      {"now_s", [](auto& wire) { wire.now_s = kNan; }},
      {"scan: stamp_s", [](auto& wire) { wire.scan.stamp_s = kNan; }},
      {"scan: first_rad", [](auto& wire) { wire.scan.first_rad = 11.0; }},
      {"scan: step_rad", [](auto& wire) { wire.scan.step_rad = 0.0; }},
      {"scan: step_rad", [](auto& wire) { wire.scan.step_rad = 1.0; }},
      {"scan: ranges_m", [](auto& wire) { wire.scan.ranges_m._buffer[5] = std::nanf(""); }},
      {"scan: ranges_m", [](auto& wire) { wire.scan.ranges_m._buffer[682] = -0.1F; }},
      {"scan: ranges_m", [](auto& wire) { wire.scan.ranges_m._length = 4097; }},
      {"depth: ranges_m", [](auto& wire) { wire.depth.ranges_m._length = 4'000'000'000U; }},
      {"pose_stamp_s", [](auto& wire) { wire.pose_stamp_s = 1e300; }},
      {"pose must", [](auto& wire) { wire.pose.y_m = kNan; }},
      {"pose must", [](auto& wire) { wire.pose.yaw_rad = 1e4; }},
      {"heading_rad", [](auto& wire) { wire.heading_rad = kNan; }},
      {"mode", [](auto& wire) { wire.mode[0] = 'X'; }},
      {"mode", [](auto& wire) { std::memset(wire.mode, 'a', sizeof wire.mode); }},
      {"has_scan", [](auto& wire) { std::memset(&wire.has_scan, 2, 1); }},
      {"has_depth", [](auto& wire) { std::memset(&wire.has_depth, 77, 1); }},
      {"has_pose", [](auto& wire) { std::memset(&wire.has_pose, 2, 1); }},
      {"has_heading", [](auto& wire) { std::memset(&wire.has_heading, 2, 1); }},
      {"is_switching", [](auto& wire) { std::memset(&wire.is_switching, 2, 1); }},
      {"has_fallen", [](auto& wire) { std::memset(&wire.has_fallen, 255, 1); }},
  };
  for (const auto& [field, spoil] : cases) {
    const WireSenses wire = toWire(1, full.senses(), nao());
    const auto scan_length = wire->scan.ranges_m._length;
    spoil(*wire);
    const auto heard = fromWire(*wire, nao());
    ASSERT_FALSE(heard) << field;
    EXPECT_TRUE(heard.error().message.starts_with(field)) << heard.error().message;
    wire->scan.ranges_m._length = wire->depth.ranges_m._length = scan_length;  // to be freed as it was made
    wire->has_scan = wire->has_depth = wire->has_pose = wire->has_heading = true;
    wire->is_switching = wire->has_fallen = false;
  }
}

/// Whatever bytes come in the fixed part, what is taken is sound.
TEST(ConvertSenses, ofRandomBytesAreRefusedOrSound) {
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    std::mt19937_64 random(seed);
    const HeardSenses told = randomSenses(seed % 50);
    const WireSenses wire = toWire(1, told.senses(), nao());
    underway_Senses spoilt = *wire;  // shares its ranges
    auto* const bytes = reinterpret_cast<unsigned char*>(&spoilt);
    for (int i = 0; i < 4; ++i) {
      const std::size_t at = random() % sizeof spoilt;
      const bool is_pointer = (at >= offsetof(underway_Senses, scan.ranges_m) &&
                               at < offsetof(underway_Senses, scan.ranges_m) + sizeof spoilt.scan.ranges_m) ||
                              (at >= offsetof(underway_Senses, depth.ranges_m) &&
                               at < offsetof(underway_Senses, depth.ranges_m) + sizeof spoilt.depth.ranges_m);
      if (!is_pointer) bytes[at] = static_cast<unsigned char>(random());
    }
    const auto heard = fromWire(spoilt, nao());
    if (!heard) continue;
    EXPECT_LT(heard->rest.mode, nao().modes.size()) << "seed " << seed;
    EXPECT_TRUE(std::isfinite(heard->rest.now_s)) << "seed " << seed;
    if (heard->scan) {
      EXPECT_EQ(heard->scan->ranges_m.size(), Beams{}.count) << "seed " << seed;
    }
    if (heard->depth) {
      EXPECT_EQ(heard->depth->ranges_m.size(), heard->depth->beams.count) << "seed " << seed;
    }
    if (heard->rest.pose) {
      EXPECT_LE(std::abs(heard->rest.pose->pose.yaw), 3.1416) << "seed " << seed;
    }
  }
}

TEST(ConvertCommand, arrivesAsItWasSent) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Command sent = randomCommand(seed);
    const auto heard = fromWire(toWire(seed, sent, nao()), nao());
    ASSERT_TRUE(heard) << "seed " << seed << ": " << heard.error().message;
    EXPECT_EQ(heard->tick, seed);
    EXPECT_EQ(heard->command, sent) << "seed " << seed;
  }
}

TEST(ConvertCommand, isRefusedByFieldWhenAnythingIsOutOfRange) {
  const std::pair<const char*, void (*)(underway_Command&)> cases[] = {
      {"the velocity", [](auto& wire) { wire.x_mps = kNan; }},
      {"the velocity", [](auto& wire) { wire.y_mps = -10.5; }},
      {"the velocity", [](auto& wire) { wire.turn_radps = std::numeric_limits<double>::infinity(); }},
      {"look_rad", [](auto& wire) { wire.look_rad = kNan; }},
      {"change_to", [](auto& wire) { std::strcpy(wire.change_to, "fly"); }},
      {"change_to", [](auto& wire) { std::memset(wire.change_to, 'a', sizeof wire.change_to); }},
  };
  for (const auto& [field, spoil] : cases) {
    underway_Command wire = toWire(1, Command{}, nao());
    spoil(wire);
    const auto heard = fromWire(wire, nao());
    ASSERT_FALSE(heard) << field;
    EXPECT_TRUE(heard.error().message.starts_with(field)) << heard.error().message;
  }
}

}  // namespace
}  // namespace underway
