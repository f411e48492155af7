#include "geometry/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/fingerprint.hpp"

namespace underway {
namespace {

constexpr double kRounding = 1e-14;  // of coordinates through a frame, relative
constexpr double kSmallestBounds_m = 0.01;

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
  if (!isSane(bounds.width_m) || !isSane(bounds.height_m) || bounds.width_m < kSmallestBounds_m ||
      bounds.height_m < kSmallestBounds_m)
    return "the bounds must have a width and a height above 0.01 m and below 100 km";
  return {};
}

std::string faultOf(const Obstacle& obstacle) {
  if (obstacle.id.empty()) return "an obstacle has no id";
  const std::string fault = faultOf(obstacle.box);
  return fault.empty() ? fault : "obstacle \"" + obstacle.id + "\": " + fault;
}

tl::unexpected<Error> refusal(const std::string& map, const std::string& what) {
  return fail(ErrorCode::kInvalidMap, "map \"" + map + "\": " + what);
}

tl::unexpected<Error> noSuchObstacle(const std::string& map, std::string_view id) {
  return refusal(map, "there is no obstacle \"" + std::string(id) + "\"; add it first");
}

/// Scatters every bit over all of a number (the finaliser of splitmix64, Steele, Lea and Flood 2014): so that
/// a sum of such numbers tells of its parts.
std::uint64_t scattered(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

std::uint64_t fingerprintOf(const Obstacle& obstacle) {
  Fingerprint print;
  print.add(obstacle.id);
  for (const Vec3& v : {obstacle.box.center_m, obstacle.box.size_m, obstacle.box.rpy_rad})
    print.add(v.x).add(v.y).add(v.z);
  return scattered(print.value());
}

/// A point of the map frame in a frame.
Point inFrame(const Pose& frame, Point point) {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  return {c * (point.x - frame.x) + s * (point.y - frame.y),
          -s * (point.x - frame.x) + c * (point.y - frame.y)};
}

}  // namespace

bool Bounds::contains(Point point) const {
  const Point local = inFrame(corner, point);
  const double slack = kRounding * (std::abs(corner.x) + std::abs(corner.y) + width_m + height_m);
  return local.x >= -slack && local.x <= width_m + slack && local.y >= -slack && local.y <= height_m + slack;
}

bool Bounds::containsArc(Point center, double radius_m, double from_rad, double angle_rad) const {
  const double begin = (angle_rad < 0.0 ? from_rad + angle_rad : from_rad) - corner.yaw;
  const double angle = std::min(std::abs(angle_rad), 2.0 * std::numbers::pi);
  const Point middle = inFrame(corner, center);
  const auto reaches = [&](double direction) { return counterClockwise(begin, direction) <= angle; };
  const auto is_inside = [&](double direction) {
    return contains(transform(
        corner, {middle.x + radius_m * std::cos(direction), middle.y + radius_m * std::sin(direction)}));
  };
  // An arc is furthest out at its ends and where it runs along an edge.
  if (!is_inside(begin) || !is_inside(begin + angle)) return false;
  for (const double quarter : {0.0, 0.5, 1.0, 1.5})
    if (const double along = quarter * std::numbers::pi; reaches(along) && !is_inside(along)) return false;
  return true;
}

std::array<Point, 4> Bounds::corners() const {
  return {corner.position(), transform(corner, {width_m, 0.0}), transform(corner, {width_m, height_m}),
          transform(corner, {0.0, height_m})};
}

Expected<World> World::make(std::string name, Bounds bounds, double floor_z_m,
                            std::vector<Obstacle> obstacles) {
  const auto refuse = [&](const std::string& what) { return refusal(name, what); };
  if (const std::string fault = faultOf(bounds); !fault.empty()) return refuse(fault);
  if (!isSane(floor_z_m)) return refuse("floor_z_m must be finite and within 100 km");
  World world;
  for (const Obstacle& obstacle : obstacles) {
    if (const std::string fault = faultOf(obstacle); !fault.empty()) return refuse(fault);
    world.fingerprint_ += fingerprintOf(obstacle);
  }
  std::sort(obstacles.begin(), obstacles.end(),
            [](const Obstacle& a, const Obstacle& b) { return a.id < b.id; });
  std::optional<std::string> twin;
  world.obstacles_ = Obstacles(std::move(obstacles), twin);
  if (twin) return refuse("obstacle id \"" + *twin + "\" is given twice");
  world.name_ = std::move(name);
  world.bounds_ = bounds;
  world.floor_z_m_ = floor_z_m;
  return world;
}

World World::next(Obstacles obstacles, std::uint64_t gone, std::uint64_t come) const {
  World world;
  world.name_ = name_;
  world.bounds_ = bounds_;
  world.floor_z_m_ = floor_z_m_;
  world.obstacles_ = std::move(obstacles);
  world.fingerprint_ = fingerprint_ + come - gone;
  world.revision_ = revision_ + 1;
  return world;
}

Expected<World> World::added(Obstacle obstacle) const {
  if (const std::string fault = faultOf(obstacle); !fault.empty()) return refusal(name_, fault);
  if (obstacles_.find(obstacle.id))
    return refusal(name_,
                   "obstacle id \"" + obstacle.id + "\" is taken; move that obstacle, or choose another id");
  const std::uint64_t come = fingerprintOf(obstacle);
  return next(obstacles_.with(std::move(obstacle)), 0, come);
}

Expected<World> World::moved(std::string_view id, const OrientedBox& box) const {
  const auto at = obstacles_.find(id);
  if (!at) return noSuchObstacle(name_, id);
  const Obstacle changed{std::string(id), box};
  if (const std::string fault = faultOf(changed); !fault.empty()) return refusal(name_, fault);
  return next(obstacles_.withBox(*at, box), fingerprintOf(obstacles_[*at]), fingerprintOf(changed));
}

Expected<World> World::removed(std::string_view id) const {
  const auto at = obstacles_.find(id);
  if (!at) return noSuchObstacle(name_, id);
  return next(obstacles_.without(*at), fingerprintOf(obstacles_[*at]), 0);
}

std::string World::hash() const {
  Fingerprint print;
  print.add(bounds_.corner.x).add(bounds_.corner.y).add(bounds_.corner.yaw);
  print.add(bounds_.width_m).add(bounds_.height_m).add(floor_z_m_);
  return print.add(std::uint64_t{obstacles_.size()}).add(fingerprint_).hex();
}

}  // namespace underway
