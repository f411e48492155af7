#include "local/surprises.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/checker.hpp"
#include "local/low.hpp"
#include "local/seen_floor.hpp"
#include "local/seen_from.hpp"
#include "local/window.hpp"

namespace underway {
namespace {

constexpr std::string_view kPrefix = "seen_";
constexpr double kBeside_m = 0.1;  // nearer to a crawl than this

Obstacle obstacleAt(Point seen, double size_m, const World& world, const Robot& robot) {
  const double height = robot.modes.front().body_m.z.max;
  const auto cell = [](double x) { return std::to_string(std::lround(std::floor(x / Window::kCell_m))); };
  return {std::string(kPrefix) + cell(seen.x) + "_" + cell(seen.y),
          {{seen.x, seen.y, world.floorZ() + 0.5 * height}, {size_m, size_m, height}, {}}};
}

bool standsOn(const BodyBox& body, Point p) {
  constexpr double kHalf_m = 0.045;  // of the largest box, along its diagonal
  return p.x > body.x.min - kHalf_m && p.x < body.x.max + kHalf_m && p.y > body.y.min - kHalf_m &&
         p.y < body.y.max + kHalf_m;
}

/// Where a row of points seems to end, it may go on: two more beyond its end, as far apart as cells.
void addBeyondEnds(std::span<const Point> seen, std::vector<Point>& points) {
  constexpr double kNear_m = 0.09;
  constexpr double kEnd = 0.7;  // how much to one side the neighbours of an end lie, 1: all in one direction
  for (const Point p : seen) {
    Point sum{0.0, 0.0};
    double count = 0.0;
    for (const Point q : seen) {
      const double apart = distance(p, q);
      if (apart == 0.0 || apart > kNear_m) continue;
      sum.x += (q.x - p.x) / apart;
      sum.y += (q.y - p.y) / apart;
      count += 1.0;
    }
    const double size = std::hypot(sum.x, sum.y);
    if (count == 0.0 || size < kEnd * count) continue;
    for (const double beyond : {Window::kCell_m, 2.0 * Window::kCell_m})
      points.push_back({p.x - beyond * sum.x / size, p.y - beyond * sum.y / size});
  }
}

}  // namespace

World withSurprises(const World& base, std::span<const Point> seen, const Caution& caution,
                    const Robot& robot, ModeId mode, const Pose& at) {
  World world = base;
  const SeenFrom robots(at);
  std::vector<Point> points(seen.begin(), seen.end());
  if (caution.extends_ends) addBeyondEnds(seen, points);
  for (const Point point : points) {
    if (standsOn(robot.modes[mode].body_m, robots(point))) continue;
    if (auto with = world.added(obstacleAt(point, caution.size_m, world, robot))) world = std::move(*with);
  }
  return world;
}

World withUnseenFloor(const World& base, std::span<const Point> unseen, const Robot& robot, ModeId mode,
                      const Pose& at) {
  constexpr double kCell_m = SeenFloor::kCell_m;
  const SeenFrom robots(at);
  const double beside_m = robot.margin_m + 0.5 * kCell_m;
  const Range x = robot.modes[mode].body_m.x.grown(beside_m);
  const Range y = robot.modes[mode].body_m.y.grown(beside_m);
  std::vector<Point> cells;
  for (const Point cell : unseen) {
    const Point local = robots(cell);
    if (local.x < x.min || local.x > x.max || local.y < y.min || local.y > y.max) cells.push_back(cell);
  }
  std::sort(cells.begin(), cells.end(),
            [](Point a, Point b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
  const double height = robot.modes.front().body_m.z.max;
  World world = base;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto end = std::adjacent_find(
        first, cells.end(), [](Point a, Point b) { return a.y != b.y || b.x - a.x > 1.5 * kCell_m; });
    const auto last = end == cells.end() ? std::prev(end) : end;
    const std::string id =
        std::string(kPrefix) + "not_" + std::to_string(std::distance(cells.begin(), first));
    const OrientedBox row{{0.5 * (first->x + last->x), first->y, world.floorZ() + 0.5 * height},
                          {last->x - first->x + kCell_m, kCell_m, height},
                          {}};
    if (auto with = world.added({id, row})) world = std::move(*with);
    first = std::next(last);
  }
  return world;
}

std::vector<std::string> surprisesBesideCrawl(const Plan& plan, const std::shared_ptr<const World>& world,
                                              const std::shared_ptr<const Robot>& robot) {
  constexpr std::size_t kMost = 1000;  // of what is near, mapped things too
  const Checker checker(world, robot);
  std::vector<std::string> beside;
  bool is_down = false;
  for (const Segment& segment : plan.segments) {
    const Motion& motion = segment.motion;
    is_down |= motion.kind == MotionKind::kSwitch && isLow(*robot, motion.to_mode);
    if (!is_down) continue;  // who lies already has to go on
    for (const std::string& id : checker.blockers(motion, kBeside_m, kMost))
      if (id.starts_with(kPrefix)) beside.push_back(id);
    is_down = isLow(*robot, motion.to_mode);
  }
  return beside;
}

World withBerth(const World& world, std::span<const std::string> ids) {
  World wider = world;
  for (const std::string& id : ids) {
    const auto found = world.obstacles().find(id);
    if (!found) continue;
    OrientedBox box = world.obstacles()[*found].box;
    box.size_m.x += 2.0 * kBeside_m;
    box.size_m.y += 2.0 * kBeside_m;
    if (auto moved = wider.moved(id, box)) wider = std::move(*moved);
  }
  return wider;
}

}  // namespace underway
