#include "geometry/world.hpp"

#include <cmath>
#include <unordered_set>

#include "geometry/fingerprint.hpp"

namespace underway {
namespace {

bool isSane(double value) { return std::isfinite(value) && std::abs(value) <= World::kLargest_m; }
bool isSane(const Vec3& v) { return isSane(v.x) && isSane(v.y) && isSane(v.z); }

std::string faultOf(const OrientedBox& box) {
  if (!isSane(box.center_m)) return "center_m must be finite and within 100 km";
  if (!isSane(box.size_m)) return "size_m must be finite and within 100 km";
  if (!isSane(box.rpy_rad)) return "rpy_rad must be finite";
  if (!(box.size_m.x > 0.0 && box.size_m.y > 0.0 && box.size_m.z > 0.0))
    return "size_m must be above 0 in x, y and z";
  return {};
}

std::string faultOf(const Bounds& bounds) {
  if (!isSane(bounds.corner.x) || !isSane(bounds.corner.y) || !isSane(bounds.corner.yaw))
    return "the bounds' corner must be finite and within 100 km";
  if (!isSane(bounds.width_m) || !isSane(bounds.height_m) || bounds.width_m <= 0.0 || bounds.height_m <= 0.0)
    return "the bounds must have a width and a height above 0 and below 100 km";
  return {};
}

}  // namespace

bool Bounds::contains(Point point) const {
  if (corner.yaw == 0.0)  // not through cos and sin: a body may stand exactly on the edge
    return point.x >= corner.x && point.x <= corner.x + width_m && point.y >= corner.y &&
           point.y <= corner.y + height_m;
  const double c = std::cos(corner.yaw);
  const double s = std::sin(corner.yaw);
  const double along = c * (point.x - corner.x) + s * (point.y - corner.y);
  const double across = -s * (point.x - corner.x) + c * (point.y - corner.y);
  return along >= 0.0 && along <= width_m && across >= 0.0 && across <= height_m;
}

std::array<Point, 4> Bounds::corners() const {
  return {corner.position(), transform(corner, {width_m, 0.0}), transform(corner, {width_m, height_m}),
          transform(corner, {0.0, height_m})};
}

Expected<World> World::make(std::string name, Bounds bounds, double floor_z_m,
                            std::vector<Obstacle> obstacles) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorCode::kInvalidMap, "map \"" + name + "\": " + what);
  };
  if (const std::string fault = faultOf(bounds); !fault.empty()) return refuse(fault);
  if (!isSane(floor_z_m)) return refuse("floor_z_m must be finite and within 100 km");
  std::unordered_set<std::string_view> ids;
  ids.reserve(obstacles.size());
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.id.empty()) return refuse("an obstacle has no id");
    if (const std::string fault = faultOf(obstacle.box); !fault.empty())
      return refuse("obstacle \"" + obstacle.id + "\": " + fault);
    if (!ids.insert(obstacle.id).second) return refuse("obstacle id \"" + obstacle.id + "\" is given twice");
  }
  World world;
  world.name_ = std::move(name);
  world.bounds_ = bounds;
  world.floor_z_m_ = floor_z_m;
  world.obstacles_ = std::move(obstacles);
  return world;
}

std::string World::hash() const {
  Fingerprint print;
  print.add(bounds_.corner.x).add(bounds_.corner.y).add(bounds_.corner.yaw);
  print.add(bounds_.width_m).add(bounds_.height_m).add(floor_z_m_);
  for (const Obstacle& obstacle : obstacles_) {
    print.add(obstacle.id);
    for (const Vec3& v : {obstacle.box.center_m, obstacle.box.size_m, obstacle.box.rpy_rad})
      print.add(v.x).add(v.y).add(v.z);
  }
  return print.hex();
}

}  // namespace underway
