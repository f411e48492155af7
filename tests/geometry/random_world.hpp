#pragma once

#include <memory>
#include <numbers>
#include <random>

#include "geometry/checker.hpp"

namespace underway::test {

/// Random worlds and motions for property tests: crowded enough that about half of all motions collide.
class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int oneOf(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
  double angle() { return between(-std::numbers::pi, std::numbers::pi); }

  OrientedBox box(bool may_tilt) {
    OrientedBox box{{between(0.0, 4.0), between(0.0, 4.0), between(-0.2, 1.0)},
                    {between(0.02, 0.8), between(0.02, 0.8), between(0.02, 0.8)},
                    {0.0, 0.0, angle()}};
    if (may_tilt && oneOf(2) == 0) box.rpy_rad = {between(-1.5, 1.5), between(-1.5, 1.5), angle()};
    return box;
  }

  std::shared_ptr<const World> world(int boxes, bool may_tilt = true) {
    std::vector<Obstacle> obstacles;
    for (int i = 0; i < boxes; ++i) obstacles.push_back({"box_" + std::to_string(i), box(may_tilt)});
    return std::make_shared<const World>(
        *World::make("random", {{-2.0, -2.0, 0.0}, 8.0, 8.0}, 0.0, obstacles));
  }

  Pose pose() { return {between(0.0, 4.0), between(0.0, 4.0), angle()}; }

  Motion motion(const Robot& robot) {
    const auto mode = static_cast<ModeId>(oneOf(static_cast<int>(robot.modes.size())));
    switch (oneOf(4)) {
      case 0:
        return stay(mode, pose());
      case 1:
        return translate(mode, kSenses[static_cast<std::size_t>(oneOf(4))], pose(), between(0.0, 1.0));
      case 2: {
        const Pose from = pose();
        const double angle_rad = between(-4.0, 4.0);
        return turn(mode, from, angle_rad, normalizedAngle(from.yaw + angle_rad));
      }
      default:
        return switchModes(
            robot.switches[static_cast<std::size_t>(oneOf(static_cast<int>(robot.switches.size())))], pose());
    }
  }

 private:
  std::mt19937 random_;
};

/// NAO's modes in small, so that tests need no file: it walks, sidesteps and crawls.
inline std::shared_ptr<const Robot> smallRobot() {
  Robot robot;
  robot.name = "small";
  robot.margin_m = 0.02;
  Mode walk;
  walk.name = "walk";
  walk.body_m = {{-0.13, 0.13}, {-0.195, 0.195}, {0.0, 0.585}};
  walk.speed_mps = {0.068, 0.04, 0.0, 0.0};
  walk.turn_speed_radps = 0.17;
  Mode sidestep = walk;
  sidestep.name = "sidestep";
  sidestep.speed_mps = {0.0, 0.0, 0.04, 0.04};
  Mode crawl;
  crawl.name = "crawl";
  crawl.body_m = {{-0.30, 0.36}, {-0.195, 0.195}, {0.0, 0.21}};
  crawl.speed_mps = {0.025, 0.0, 0.0, 0.0};
  crawl.drift_m_per_m = 0.02;
  robot.modes = {walk, sidestep, crawl};
  robot.switches = {{0, 1, 0.0, {}, {}},
                    {1, 0, 0.0, {}, {}},
                    {0, 2, 8.0, {0.30, 0.0, 0.0}, {{-0.13, 0.66}, {-0.195, 0.195}, {0.0, 0.585}}},
                    {2, 0, 12.0, {0.10, 0.0, 0.0}, {{-0.30, 0.36}, {-0.195, 0.195}, {0.0, 0.585}}}};
  return std::make_shared<const Robot>(*checkedRobot(robot));
}

}  // namespace underway::test
