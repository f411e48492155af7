#include "geometry/fcl_shapes.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>

namespace underway {
namespace {

constexpr double kHair_m = 1e-9;

/// A shape where it is. All that is ours is its bounding box, which spares FCL what is far away.
template <class Geometry>
struct Placed {
  Placed(const Geometry& geometry, const fcl::Transform3d& placed, const fcl::Vector3d& half_m)
      : shape(geometry), at(placed), reach_m(placed.linear().cwiseAbs() * half_m) {}
  Geometry shape;
  fcl::Transform3d at;
  fcl::Vector3d reach_m;  // of the bounding box, from the middle
};
using PlacedBox = Placed<fcl::Boxd>;
using PlacedCylinder = Placed<fcl::Cylinderd>;

PlacedBox placed(const fcl::Vector3d& size_m, const fcl::Transform3d& at) {
  return {fcl::Boxd(size_m), at, 0.5 * size_m};
}

PlacedBox placed(const OrientedBox& box) {
  fcl::Transform3d at = fcl::Transform3d::Identity();
  const Rotation rows = rotation(box);
  for (int i = 0; i < 3; ++i) {
    const Vec3& row = rows[static_cast<std::size_t>(i)];
    at.linear().row(i) << row.x, row.y, row.z;
  }
  at.translation() << box.center_m.x, box.center_m.y, box.center_m.z;
  return placed({box.size_m.x, box.size_m.y, box.size_m.z}, at);
}

PlacedBox placed(const Prism& box) {
  const double c = std::cos(box.frame.yaw);
  const double s = std::sin(box.frame.yaw);
  const Point middle{0.5 * (box.x.min + box.x.max), 0.5 * (box.y.min + box.y.max)};
  fcl::Transform3d at = fcl::Transform3d::Identity();
  at.linear() << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  at.translation() << box.frame.x + c * middle.x - s * middle.y, box.frame.y + s * middle.x + c * middle.y,
      0.5 * (box.z.min + box.z.max);
  return placed({box.x.length(), box.y.length(), box.z.length() + 2.0 * kHair_m}, at);
}

PlacedCylinder cylinderAt(Point center, double radius_m, Range z) {
  fcl::Transform3d at = fcl::Transform3d::Identity();
  at.translation() << center.x, center.y, 0.5 * (z.min + z.max);
  const double height_m = z.length() + 2.0 * kHair_m;
  return {fcl::Cylinderd(radius_m, height_m), at, {radius_m, radius_m, 0.5 * height_m}};
}

template <class A, class B>
bool collide(const Placed<A>& a, const Placed<B>& b) {
  const fcl::Vector3d apart = (a.at.translation() - b.at.translation()).cwiseAbs();
  if (((apart - a.reach_m - b.reach_m).array() > kHair_m).any()) return false;
  static const fcl::CollisionRequestd kBoolean(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(&a.shape, a.at, &b.shape, b.at, kBoolean, result) > 0;
}

/// Whether a shape comes within a distance of a box: the box grown along either axis, and a cylinder round
/// each edge, are together all points within the distance.
bool comesWithin(const PlacedBox& shape, const Prism& box, double distance_m) {
  if (distance_m <= 0.0) return collide(placed(box), shape);
  if (!collide(placed(box.grown(distance_m)), shape)) return false;  // its square corners reach even further
  if (collide(placed(Prism{box.frame, box.x.grown(distance_m), box.y, box.z}), shape) ||
      collide(placed(Prism{box.frame, box.x, box.y.grown(distance_m), box.z}), shape))
    return true;
  const auto footprint = box.footprint();
  return std::any_of(footprint.begin(), footprint.end(),
                     [&](Point corner) { return collide(cylinderAt(corner, distance_m, box.z), shape); });
}

}  // namespace

struct FclShapes::Shapes {
  std::vector<Obstacles::Pointer> obstacles;
  std::vector<PlacedBox> placed;
};

FclShapes::FclShapes(const std::vector<Obstacles::Pointer>& obstacles) {
  auto shapes = std::make_unique<Shapes>();
  shapes->obstacles = obstacles;
  shapes->placed.reserve(obstacles.size());
  for (const Obstacles::Pointer& obstacle : obstacles) shapes->placed.push_back(placed(obstacle->box));
  shapes_ = std::move(shapes);
}
FclShapes::~FclShapes() = default;
FclShapes::FclShapes(FclShapes&&) noexcept = default;

std::size_t FclShapes::size() const { return shapes_->placed.size(); }
const OrientedBox& FclShapes::box(std::size_t i) const { return shapes_->obstacles[i]->box; }

bool FclShapes::comesWithin(std::size_t i, const Prism& box, double distance_m) const {
  return underway::comesWithin(shapes_->placed[i], box, distance_m);
}

bool FclShapes::comeWithin(const Prism& box, double distance_m) const {
  return std::any_of(shapes_->placed.begin(), shapes_->placed.end(),
                     [&](const PlacedBox& shape) { return underway::comesWithin(shape, box, distance_m); });
}

bool comeWithin(const Prism& a, const Prism& b, double distance_m) {
  return comesWithin(placed(a), b, distance_m);
}

}  // namespace underway
