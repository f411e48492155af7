#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/draw_layers.hpp"
#include "geometry/convex.hpp"

namespace underway {
namespace {

constexpr std::size_t kMostRoadmapLines = 4000;
constexpr double kLargestGrid_m = 40.0;  // lines of 1 m on a larger floor would be noise

/// The obstacle from above: of an upright box its rectangle, of a tilted one the hull of its corners.
std::vector<Point> outlineOf(const OrientedBox& box) {
  const std::array<Vec3, 8> all = corners(box);
  std::vector<Point> points;
  if (box.rpy_rad.x == 0.0 && box.rpy_rad.y == 0.0) {
    for (const int i : {0, 1, 3, 2}) points.push_back({all[i].x, all[i].y});
    return points;
  }
  for (const Vec3& corner : all) points.push_back({corner.x, corner.y});
  return convexHull(std::move(points));
}

std::string drawGrid(const Bounds& bounds, const View& view) {
  if (std::max(bounds.width_m, bounds.height_m) > kLargestGrid_m) return {};
  PathData lines(view);
  for (double x = 1.0; x < bounds.width_m; x += 1.0)
    lines.line(transform(bounds.corner, {x, 0.0}), transform(bounds.corner, {x, bounds.height_m}));
  for (double y = 1.0; y < bounds.height_m; y += 1.0)
    lines.line(transform(bounds.corner, {0.0, y}), transform(bounds.corner, {bounds.width_m, y}));
  return lines.element("stroke=\"#eef1f5\" stroke-width=\"1\"");
}

}  // namespace

bool isSeenBy(const Obstacle& obstacle, const Mode& mode, double floor_z_m) {
  const std::array<Vec3, 8> all = corners(obstacle.box);
  const auto [low, high] =
      std::minmax_element(all.begin(), all.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  constexpr double kLowestSeen_m = 0.005;  // formats: 'Free'
  return high->z >= floor_z_m + std::max(mode.step_over_m, kLowestSeen_m) &&
         low->z <= floor_z_m + mode.body_m.z.max;
}

Blocks blocksOf(const Obstacle& obstacle, const World& world, const Robot& robot) {
  const auto seen = std::count_if(robot.modes.begin(), robot.modes.end(),
                                  [&](const Mode& mode) { return isSeenBy(obstacle, mode, world.floorZ()); });
  if (seen == 0) return Blocks::kNone;
  return seen == static_cast<std::ptrdiff_t>(robot.modes.size()) ? Blocks::kEvery : Blocks::kSome;
}

std::string_view paintOf(Blocks blocks) {
  switch (blocks) {
    case Blocks::kEvery:
      return "fill=\"#39424e\"";
    case Blocks::kSome:
      return "fill=\"url(#low)\" stroke=\"#a58a5b\" stroke-width=\"1\"";
    case Blocks::kNone:
      return "fill=\"none\" stroke=\"#9aa5b1\" stroke-width=\"1\" stroke-dasharray=\"3 3\"";
  }
  return {};
}

std::string drawFloor(const Picture& picture, const View& view) {
  const Bounds& bounds = picture.world.bounds();
  const std::array<Point, 4> corners = bounds.corners();
  PathData floor(view);
  floor.polygon(corners);
  return floor.element("fill=\"#fff\"") + drawGrid(bounds, view) +
         floor.element("fill=\"none\" stroke=\"#5c6773\" stroke-width=\"1.5\"");
}

std::string drawRoadmap(const Picture& picture, const View& view) {
  if (picture.roadmap == nullptr) return {};
  const Roadmap& roadmap = *picture.roadmap;
  const auto is_line = [&](Roadmap::LinkId id) {  // both ways are one line
    const Roadmap::Link& link = roadmap.links[id];
    return roadmap.ways[id] != 0 &&
           (link.twin == Roadmap::kNone || id < link.twin || roadmap.ways[link.twin] == 0);
  };
  std::vector<Roadmap::LinkId> lines;
  for (Roadmap::LinkId id = 0; id < roadmap.links.size(); ++id)
    if (is_line(id)) lines.push_back(id);
  const std::size_t step = 1 + lines.size() / kMostRoadmapLines;
  PathData path(view);
  for (std::size_t i = 0; i < lines.size(); i += step)
    path.line(roadmap.places[roadmap.links[lines[i]].from].at, roadmap.places[roadmap.links[lines[i]].to].at);
  return path.element("fill=\"none\" stroke=\"#8a97a6\" stroke-width=\"0.5\" stroke-opacity=\"0.35\"");
}

std::string drawObstacles(const Picture& picture, const View& view) {
  std::array<PathData, 3> paths{PathData(view), PathData(view), PathData(view)};
  for (const Obstacle& obstacle : picture.world.obstacles())
    paths[static_cast<std::size_t>(blocksOf(obstacle, picture.world, picture.robot))].polygon(
        outlineOf(obstacle.box));
  std::string text;
  for (const Blocks blocks : {Blocks::kNone, Blocks::kSome, Blocks::kEvery})
    text += paths[static_cast<std::size_t>(blocks)].element(paintOf(blocks));
  return text;
}

}  // namespace underway
