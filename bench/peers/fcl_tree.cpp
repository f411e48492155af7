#include "bench/peers/fcl_tree.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision.h>

#include <cmath>
#include <vector>

namespace underway::bench {
namespace {

constexpr double kHair_m = 1e-9;

using Object = fcl::CollisionObjectd;

Object objectOf(const OrientedBox& box) {
  fcl::Transform3d placed = fcl::Transform3d::Identity();
  const Rotation rows = rotation(box);
  for (int i = 0; i < 3; ++i) {
    const Vec3& row = rows[static_cast<std::size_t>(i)];
    placed.linear().row(i) << row.x, row.y, row.z;
  }
  placed.translation() << box.center_m.x, box.center_m.y, box.center_m.z;
  return {std::make_shared<fcl::Boxd>(box.size_m.x, box.size_m.y, box.size_m.z), placed};
}

/// What a walk through the tree carries along.
struct Walk {
  const Object* query;
  bool found;
};

bool step(Object* a, Object* b, void* data) {
  static const fcl::CollisionRequestd kBoolean(1, false);
  Walk& walk = *static_cast<Walk*>(data);
  fcl::CollisionResultd result;
  walk.found = fcl::collide(a, b, kBoolean, result) > 0;
  return walk.found;
}

}  // namespace

struct FclBody::Object {
  Object(Range x, Range y, Range z)
      : middle{0.5 * (x.min + x.max), 0.5 * (y.min + y.max)},
        middle_z(0.5 * (z.min + z.max)),
        fcl(std::make_shared<fcl::Boxd>(x.length(), y.length(), z.length() + 2.0 * kHair_m)) {}
  Point middle;  // in the body frame
  double middle_z;
  mutable fcl::CollisionObjectd fcl;  // FCL takes pointers to non-const, and changes nothing
};

FclBody::FclBody(Range x, Range y, Range z) : object_(std::make_unique<Object>(x, y, z)) {}
FclBody::~FclBody() = default;
FclBody::FclBody(FclBody&&) noexcept = default;

void FclBody::place(const Pose& frame) {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  const Point m = object_->middle;
  fcl::Transform3d at = fcl::Transform3d::Identity();
  at.linear() << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  at.translation() << frame.x + c * m.x - s * m.y, frame.y + s * m.x + c * m.y, object_->middle_z;
  object_->fcl.setTransform(at);
  object_->fcl.computeAABB();
}

struct FclTree::Tree {
  std::vector<Object> objects;
  fcl::DynamicAABBTreeCollisionManagerd manager;
};

FclTree::FclTree(const Obstacles& obstacles) {
  auto tree = std::make_unique<Tree>();
  tree->objects.reserve(obstacles.size());
  std::vector<Object*> all;
  for (const Obstacle& obstacle : obstacles)
    all.push_back(&tree->objects.emplace_back(objectOf(obstacle.box)));
  tree->manager.registerObjects(all);
  tree->manager.setup();
  tree_ = std::move(tree);
}
FclTree::~FclTree() = default;
FclTree::FclTree(FclTree&&) noexcept = default;

bool FclTree::touches(const FclBody& body) const {
  Walk walk{&body.object_->fcl, false};
  tree_->manager.collide(&body.object_->fcl, &walk, step);
  return walk.found;
}

}  // namespace underway::bench
