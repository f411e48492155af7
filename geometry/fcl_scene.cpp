#include "geometry/fcl_scene.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <mutex>
#include <unordered_set>
#include <vector>

namespace underway {
namespace {

constexpr double kHair_m = 1e-9;
constexpr std::size_t kMostChanges = 64;  // that are carried beside a tree

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

bool collide(const Object& a, const Object& b) {
  static const fcl::CollisionRequestd kBoolean(1, false);
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, kBoolean, result) > 0;
}

}  // namespace

/// The box is a hair higher and lower than it says: one that ends flush with an obstacle counts as touching
/// here, as it does in the layers, however FCL rounds.
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

namespace {

/// Obstacles in FCL's dynamic tree.
class FclTree {
 public:
  explicit FclTree(std::vector<Obstacles::Pointer> obstacles) : obstacles_(std::move(obstacles)) {
    objects_.reserve(obstacles_.size());
    std::vector<Object*> all;
    for (const Obstacles::Pointer& obstacle : obstacles_) {
      Object& object = objects_.emplace_back(objectOf(obstacle->box));
      all.push_back(&object);
    }
    manager_.registerObjects(all);
    manager_.setup();
  }
  FclTree(const FclTree&) = delete;  // the manager points into it
  FclTree& operator=(const FclTree&) = delete;

  /// Whether an object touches an obstacle that is not among those to pass over.
  bool touches(Object& query, const std::unordered_set<const Obstacle*>& passed_over) const {
    Walk walk{&query, this, &passed_over, false};
    manager_.collide(&query, &walk, step);
    return walk.found;
  }

 private:
  /// What a walk through the tree carries along.
  struct Walk {
    const Object* query;  // FCL does not promise which of two objects is the query
    const FclTree* tree;
    const std::unordered_set<const Obstacle*>* passed_over;
    bool found;
  };

  static bool step(Object* a, Object* b, void* data) {
    Walk& walk = *static_cast<Walk*>(data);
    const Object& obstacle = a == walk.query ? *b : *a;
    if (!walk.passed_over->empty()) {
      const auto i = static_cast<std::size_t>(&obstacle - walk.tree->objects_.data());
      if (walk.passed_over->contains(walk.tree->obstacles_[i].get())) return false;
    }
    walk.found = collide(*walk.query, obstacle);
    return walk.found;
  }

  std::vector<Obstacles::Pointer> obstacles_;
  std::vector<Object> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

/// A main tree, and what it was made of.
struct Grown {
  std::shared_ptr<const Obstacles> obstacles;
  std::unique_ptr<const FclTree> tree;
};

std::vector<Obstacles::Pointer> allOf(const Obstacles& obstacles) {
  std::vector<Obstacles::Pointer> all;
  for (std::size_t i = 0; i < obstacles.size(); ++i) all.push_back(obstacles.pointer(i));
  return all;
}

}  // namespace

/// The trees of one revision: a main tree, which may be an earlier revision's, and what came since.
class FclScene::Forest {
 public:
  /// `earlier` is the main tree that was made last; null if none was.
  Forest(std::shared_ptr<const Obstacles> obstacles, std::shared_ptr<const Grown> earlier)
      : obstacles_(std::move(obstacles)), main_(std::move(earlier)) {}

  /// The main tree for a later revision to use.
  [[nodiscard]] std::shared_ptr<const Grown> main() const {
    const std::lock_guard lock(making_);
    return main_;
  }

  bool touches(Object& query) const {
    std::call_once(once_, [this] { make(); });
    static const std::unordered_set<const Obstacle*> kNone;
    return main_->tree->touches(query, gone_) || (come_ && come_->touches(query, kNone));
  }

 private:
  void make() const {
    const std::lock_guard lock(making_);
    const auto changes =
        main_ ? Obstacles::changes(*main_->obstacles, *obstacles_) : std::vector<Obstacles::Change>();
    if (!main_ || changes.size() > kMostChanges) {
      main_ = std::make_shared<const Grown>(
          Grown{obstacles_, std::make_unique<const FclTree>(allOf(*obstacles_))});
      return;
    }
    std::vector<Obstacles::Pointer> come;
    for (const auto& [before, after] : changes) {
      if (before) gone_.insert(before.get());
      if (after) come.push_back(after);
    }
    if (!come.empty()) come_ = std::make_unique<const FclTree>(std::move(come));
  }

  std::shared_ptr<const Obstacles> obstacles_;
  mutable std::once_flag once_;  // of making, by whoever asks first
  mutable std::mutex making_;    // guards main_ until it is made
  mutable std::shared_ptr<const Grown> main_;
  mutable std::unordered_set<const Obstacle*> gone_;  // of the main tree's
  mutable std::unique_ptr<const FclTree> come_;
};

FclScene::FclScene(std::shared_ptr<const Obstacles> obstacles)
    : forest_(std::make_shared<const Forest>(std::move(obstacles), nullptr)) {}
FclScene::FclScene(std::shared_ptr<const Forest> forest) : forest_(std::move(forest)) {}

FclScene FclScene::changed(std::shared_ptr<const Obstacles> after) const {
  return FclScene(std::make_shared<const Forest>(std::move(after), forest_->main()));
}

bool FclScene::touches(const FclBody& body) const { return forest_->touches(body.object_->fcl); }

bool FclScene::touches(const Prism& box) const {
  FclBody body(box.x, box.y, box.z);
  body.place(box.frame);
  return touches(body);
}

bool FclScene::touches(Point center, double radius_m, Range z) const {
  const Vec3 at{center.x, center.y, 0.5 * (z.min + z.max)};
  Object query(std::make_shared<fcl::Cylinderd>(radius_m, z.length()), placed(at, rotation(OrientedBox{})));
  return forest_->touches(query);
}

}  // namespace underway
