#include "bench/local_rooms.hpp"

#include <cmath>
#include <random>
#include <string>

namespace underway::bench {
namespace {

constexpr double kLength_m = 11.75;
constexpr double kWidth_m = 5.5;
constexpr double kGap_m = 0.73;

class Arena {
 public:
  explicit Arena(std::uint64_t seed) : random_(seed) {
    add({0.5 * kLength_m, -0.05}, kLength_m + 0.2, 0.1, 0.0);
    add({0.5 * kLength_m, kWidth_m + 0.05}, kLength_m + 0.2, 0.1, 0.0);
    add({-0.05, 0.5 * kWidth_m}, 0.1, kWidth_m, 0.0);
    add({kLength_m + 0.05, 0.5 * kWidth_m}, 0.1, kWidth_m, 0.0);
  }

  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  void add(Point center, double length_m, double depth_m, double yaw) {
    obstacles_.push_back({"wall_" + std::to_string(obstacles_.size()),
                          {{center.x, center.y, 0.4}, {length_m, depth_m, 0.8}, {0.0, 0.0, yaw}}});
  }
  PureRoom room(const Pose& start, Point goal) {
    return {std::make_shared<const World>(
                *World::make("arena", {{-0.1, -0.1, 0.0}, kLength_m + 0.2, kWidth_m + 0.2}, 0.0, obstacles_)),
            start, goal};
  }

 private:
  std::mt19937_64 random_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace

PureRoom randomGap(std::uint64_t seed) {
  Arena arena(seed);
  const double depth = arena.between(0.1, 0.3);
  const double x = arena.between(4.0, 7.75);
  const double gap = arena.between(0.7, kWidth_m - 0.7);
  const double tilt = arena.between(-0.25, 0.25);  // of the wall, about the gap
  const double reach = kWidth_m / std::cos(tilt);  // beyond the arena's walls, whatever the tilt
  for (const double side : {-1.0, 1.0}) {
    const double off = side * 0.5 * (kGap_m + reach);
    arena.add({x - std::sin(tilt) * off, gap + std::cos(tilt) * off}, depth, reach, tilt);
  }
  const Pose start{arena.between(0.6, 2.2), arena.between(0.6, kWidth_m - 0.6), arena.between(-0.8, 0.8)};
  return arena.room(start,
                    {arena.between(kLength_m - 2.2, kLength_m - 0.6), arena.between(0.6, kWidth_m - 0.6)});
}

PureRoom wallInFront(std::uint64_t seed) {
  Arena arena(seed);
  const double y = arena.between(2.4, 3.1);
  arena.add({arena.between(4.0, 7.0), y}, 0.1, arena.between(1.5, 3.0), 0.0);
  return arena.room({arena.between(0.8, 2.0), y, 0.0}, {arena.between(9.5, 11.0), y});
}

PureRoom uInFront(std::uint64_t seed) {
  Arena arena(seed);
  const double y = arena.between(2.4, 3.1);
  const double bottom = arena.between(5.0, 7.0);
  const double depth = arena.between(0.6, 1.5);
  const double width = arena.between(1.2, 2.5);
  arena.add({bottom, y}, 0.1, width + 0.2, 0.0);
  for (const double side : {-1.0, 1.0})
    arena.add({bottom - 0.05 - 0.5 * depth, y + side * 0.5 * (width + 0.1)}, depth, 0.1, 0.0);
  return arena.room({arena.between(0.8, 2.0), y, 0.0}, {arena.between(9.5, 11.0), y});
}

}  // namespace underway::bench
