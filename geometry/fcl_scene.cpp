#include "geometry/fcl_scene.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <vector>

namespace underway {
namespace {

constexpr double kFlush_m = 1e-9;

using Object = fcl::CollisionObjectd;
using Shape = std::shared_ptr<fcl::CollisionGeometryd>;

fcl::Transform3d placed(const Vec3& at, const Rotation& rows) {
  fcl::Transform3d placed = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const Vec3& row = rows[static_cast<std::size_t>(i)];
    placed.linear().row(i) << row.x, row.y, row.z;
  }
  placed.translation() << at.x, at.y, at.z;
  return placed;
}

Object objectOf(const OrientedBox& box) {
  const Shape shape = std::make_shared<fcl::Boxd>(box.size_m.x, box.size_m.y, box.size_m.z);
  return {shape, placed(box.center_m, rotation(box))};
}

/// A prism as FCL's box, a hair higher and lower: a box that ends flush with the slab counts as touching
/// here, as it does in the layers, however FCL rounds.
Object objectOf(const Prism& prism) {
  const Point middle =
      transform(prism.frame, {0.5 * (prism.x.min + prism.x.max), 0.5 * (prism.y.min + prism.y.max)});
  return objectOf(OrientedBox{{middle.x, middle.y, 0.5 * (prism.z.min + prism.z.max)},
                              {prism.x.length(), prism.y.length(), prism.z.length() + 2.0 * kFlush_m},
                              {0.0, 0.0, prism.frame.yaw}});
}

bool collide(const Object& a, const Object& b) {
  static const fcl::CollisionRequestd kBoolean(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, kBoolean, result) > 0;
}

/// What a walk through the tree carries along. FCL does not promise which of the two objects is the query.
struct Walk {
  const Object* query;
  const Object* first;  // of the obstacles, which lie in a row
  bool exact;           // test the shapes, not only their axis-aligned boxes
  const FclScene::Visit* visit;
};

bool step(Object* a, Object* b, void* data) {
  const Walk& walk = *static_cast<const Walk*>(data);
  const Object& obstacle = a == walk.query ? *b : *a;
  if (walk.exact && !collide(*walk.query, obstacle)) return false;
  return (*walk.visit)(static_cast<std::size_t>(&obstacle - walk.first));
}

}  // namespace

struct FclScene::Tree {
  std::vector<Object> obstacles;
  fcl::DynamicAABBTreeCollisionManagerd manager;

  void walk(Object query, bool exact, const Visit& visit) const {
    Walk data{&query, obstacles.data(), exact, &visit};
    manager.collide(&query, &data, step);
  }
};

FclScene::FclScene(const World& world) : tree_(std::make_unique<Tree>()) {
  tree_->obstacles.reserve(world.obstacles().size());
  std::vector<Object*> all;
  for (const Obstacle& obstacle : world.obstacles()) {
    Object& object = tree_->obstacles.emplace_back(objectOf(obstacle.box));
    all.push_back(&object);
  }
  tree_->manager.registerObjects(all);
  tree_->manager.setup();
}

FclScene::~FclScene() = default;

bool FclScene::touches(const Prism& box) const {
  bool found = false;
  visitTouched(box, [&found](std::size_t) { return found = true; });
  return found;
}

bool FclScene::touches(Point center, double radius_m, Range z) const {
  bool found = false;
  const Shape cylinder = std::make_shared<fcl::Cylinderd>(radius_m, z.length());
  const Vec3 at{center.x, center.y, 0.5 * (z.min + z.max)};
  tree_->walk(Object(cylinder, placed(at, rotation(OrientedBox{}))), true,
              [&found](std::size_t) { return found = true; });
  return found;
}

void FclScene::visitTouched(const Prism& box, const Visit& visit) const {
  tree_->walk(objectOf(box), true, visit);
}

void FclScene::visitNear(Range x, Range y, Range z, const Visit& visit) const {
  tree_->walk(objectOf(Prism{{}, x, y, z}), false, visit);
}

}  // namespace underway
