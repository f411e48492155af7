#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>

#include "server/robot/heard.hpp"
#include "tests/planner/fixture.hpp"
#include "tests/server/plan_fixture.hpp"

/// Senses with everything that senses can have.
namespace underway::fixture {

constexpr std::chrono::seconds kPatience{60};  // for what must happen: long, for slow machines

inline std::chrono::steady_clock::time_point inTime() { return std::chrono::steady_clock::now() + kPatience; }

inline HeardSenses randomSenses(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  std::bernoulli_distribution coin;
  HeardSenses senses;
  senses.tick = random();
  Senses& rest = senses.rest;
  rest.now_s = 10.0 + std::abs(number(random));
  rest.mode = static_cast<ModeId>(random() % test::nao()->modes.size());
  rest.is_switching = coin(random);
  rest.cycles = random() % 1000;
  rest.has_fallen = coin(random);
  if (coin(random))
    rest.pose = PoseEstimate{rest.now_s - 0.1, {number(random), number(random), number(random)}};
  if (coin(random)) rest.heading_rad = number(random);
  const auto scan_of = [&](const Beams& beams) {
    Scan scan{rest.now_s, beams, {}};
    for (std::size_t i = 0; i < beams.count; ++i)
      scan.ranges_m.push_back(coin(random) ? static_cast<float>(std::abs(number(random))) : Scan::kNothing);
    return scan;
  };
  if (coin(random)) senses.scan = scan_of(Beams{});
  if (coin(random)) senses.depth = scan_of(depthBeamsOf(1.5));
  return senses;
}

inline void expectSame(const std::optional<Scan>& a, const std::optional<Scan>& b, std::uint64_t seed) {
  ASSERT_EQ(a.has_value(), b.has_value()) << "seed " << seed;
  if (!a) return;
  EXPECT_EQ(a->stamp_s, b->stamp_s) << "seed " << seed;
  EXPECT_EQ(a->beams, b->beams) << "seed " << seed;
  EXPECT_EQ(a->ranges_m, b->ranges_m) << "seed " << seed;
}

inline void expectSame(const HeardSenses& a, const HeardSenses& b, std::uint64_t seed) {
  EXPECT_EQ(a.tick, b.tick) << "seed " << seed;
  EXPECT_EQ(a.rest.now_s, b.rest.now_s) << "seed " << seed;
  EXPECT_EQ(a.rest.mode, b.rest.mode) << "seed " << seed;
  EXPECT_EQ(a.rest.is_switching, b.rest.is_switching) << "seed " << seed;
  EXPECT_EQ(a.rest.cycles, b.rest.cycles) << "seed " << seed;
  EXPECT_EQ(a.rest.has_fallen, b.rest.has_fallen) << "seed " << seed;
  EXPECT_EQ(a.rest.heading_rad, b.rest.heading_rad) << "seed " << seed;
  ASSERT_EQ(a.rest.pose.has_value(), b.rest.pose.has_value()) << "seed " << seed;
  if (a.rest.pose) {
    EXPECT_EQ(a.rest.pose->stamp_s, b.rest.pose->stamp_s) << "seed " << seed;
    EXPECT_EQ(a.rest.pose->pose, b.rest.pose->pose) << "seed " << seed;
  }
  expectSame(a.scan, b.scan, seed);
  expectSame(a.depth, b.depth, seed);
}

inline Command randomCommand(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Command command{{number(random), number(random), number(random)}, std::nullopt, number(random)};
  if (seed % 2 == 0) command.change_to = static_cast<ModeId>(random() % test::nao()->modes.size());
  return command;
}

}  // namespace underway::fixture
