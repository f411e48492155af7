#include "bench/random_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace underway::bench {

double RandomGeometry::between(double low, double high) {
  return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1.0p-53);
}

std::size_t RandomGeometry::oneOf(std::size_t count) { return random_() % count; }

OrientedBox RandomGeometry::box(Point about) {
  const auto size = [&](double low, double high) {
    return Vec3{between(low, high), between(low, high), between(low, high)};
  };
  OrientedBox box{{about.x + between(-1.0, 1.0), about.y + between(-1.0, 1.0), between(-0.3, 1.0)},
                  size(0.02, 0.8),
                  {0.0, 0.0, oneOf(4) == 0 ? 0.0 : angle()}};
  switch (oneOf(6)) {
    case 0:
    case 1:
      break;
    case 2:
    case 3:
      box.rpy_rad = {between(-1.5, 1.5), between(-1.5, 1.5), angle()};
      break;
    case 4:
      box.size_m = size(1e-4, 1e-2);
      if (oneOf(2) == 0) box.rpy_rad.x = angle();
      break;
    default:
      box.size_m = {between(1.0, 50.0), between(1e-3, 0.1), between(0.1, 3.0)};
      if (oneOf(4) == 0) box.size_m.x = between(1e3, 1e4);
      if (oneOf(2) == 0) box.rpy_rad.y = between(-0.5, 0.5);
  }
  return box;
}

std::vector<Obstacle> RandomGeometry::obstacles(Point about, std::size_t count) {
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < count; ++i) obstacles.push_back({"box_" + std::to_string(i), box(about)});
  return obstacles;
}

std::vector<Obstacle> RandomGeometry::farObstacles(Point about) {
  static constexpr std::array kFurthest_m{100.0, 1e3, 8e3};
  constexpr double kNearest_m = 50.0;
  std::vector<Obstacle> obstacles;
  if (oneOf(2) == 0) return obstacles;
  const double furthest = kFurthest_m[oneOf(kFurthest_m.size())];
  for (std::size_t i = 0; i < 150; ++i) {
    const double way = between(kNearest_m, furthest);
    const double direction = angle();
    const Point at{about.x + way * std::cos(direction), about.y + way * std::sin(direction)};
    obstacles.push_back({"far_" + std::to_string(i),
                         {{at.x, at.y, 0.2}, {between(0.1, 2.0), 1.0, 1.0}, {0.0, 0.0, angle()}}});
  }
  return obstacles;
}

Prism RandomGeometry::body(Point about, Range slab) {
  static constexpr std::array kSizes{0.3, 0.3, 0.3, 0.005, 5.0};
  const double size = kSizes[oneOf(kSizes.size())];
  return {pose(about),
          {-size * between(0.2, 1.0), size * between(0.2, 1.0)},
          {-size * between(0.2, 1.0), size * between(0.2, 1.0)},
          slab};
}

Pose RandomGeometry::pose(Point about) {
  return {about.x + between(-1.5, 1.5), about.y + between(-1.5, 1.5), oneOf(8) == 0 ? 0.0 : angle()};
}

Motion RandomGeometry::motion(Point about, const Robot& robot) {
  const auto mode = static_cast<ModeId>(oneOf(robot.modes.size()));
  const Pose from = pose(about);
  switch (oneOf(3)) {
    case 0:
      return translate(mode, kSenses[oneOf(kSenses.size())], from, oneOf(8) == 0 ? 0.0 : between(0.0, 1.0));
    case 1: {
      const double turned = oneOf(6) == 0 ? between(-7.0, 7.0) : between(-2.0, 2.0);
      return turn(mode, from, turned, normalizedAngle(from.yaw + turned));
    }
    default:
      return switchModes(robot.switches[oneOf(robot.switches.size())], from);
  }
}

Point RandomGeometry::somewhere() {
  if (oneOf(4) != 0) return {0.0, 0.0};
  const double far = oneOf(2) == 0 ? 9e4 : 1e3;
  return {between(-far, far), between(-far, far)};
}

Point RandomGeometry::toContact(const std::vector<Point>& footprint, const std::vector<Point>& shadow) {
  static constexpr std::array kOff_m{0.0,  1e-12, 1e-10,  5e-10, 2e-9, 1e-8,
                                     1e-7, 9e-7,  1.1e-6, 3e-6,  1e-5, 1e-4};
  double best = -std::numeric_limits<double>::infinity();
  Point best_axis;
  const auto consider = [&](const std::vector<Point>& of, const std::vector<Point>& other, double sign) {
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Point a = of[i];
      const Point b = of[(i + 1) % of.size()];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (length < 1e-9) continue;
      const Point out{(b.y - a.y) / length, -(b.x - a.x) / length};
      double gap = std::numeric_limits<double>::infinity();
      for (const Point p : other) gap = std::min(gap, (p.x - a.x) * out.x + (p.y - a.y) * out.y);
      if (gap > best) best = gap, best_axis = {sign * out.x, sign * out.y};
    }
  };
  consider(footprint, shadow, 1.0);  // towards the shadow
  consider(shadow, footprint, -1.0);
  const double off = kOff_m[oneOf(kOff_m.size())] * (oneOf(2) == 0 ? 1.0 : -1.0);
  return {best_axis.x * (best - off), best_axis.y * (best - off)};
}

std::shared_ptr<const Robot> benchRobot() {
  Robot robot;
  robot.name = "bench";
  robot.margin_m = 0.02;
  Mode walk;
  walk.name = "walk";
  walk.body_m = {{-0.13, 0.13}, {-0.195, 0.195}, {0.0, 0.585}};
  walk.speed_mps = {0.068, 0.04, 0.04, 0.04};
  walk.turn_speed_radps = 0.17;
  Mode stoop = walk;  // off its pivot, and with a slant to each side
  stoop.name = "stoop";
  stoop.body_m = {{0.05, 0.45}, {-0.10, 0.17}, {0.0, 0.40}};
  stoop.step_over_m = 0.03;
  Mode crawl = walk;
  crawl.name = "crawl";
  crawl.body_m = {{-0.30, 0.36}, {-0.195, 0.195}, {0.0, 0.21}};
  crawl.drift_m_per_m = 0.02;
  robot.modes = {walk, stoop, crawl};
  robot.switches = {{0, 1, 1.0, {}, {}},
                    {0, 2, 8.0, {0.30, 0.0, 0.0}, {{-0.13, 0.66}, {-0.195, 0.195}, {0.0, 0.585}}},
                    {2, 0, 12.0, {0.10, 0.0, 0.2}, {{-0.30, 0.46}, {-0.25, 0.25}, {0.0, 0.585}}}};
  return std::make_shared<const Robot>(*checkedRobot(robot));
}

}  // namespace underway::bench
