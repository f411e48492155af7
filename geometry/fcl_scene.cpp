#include "geometry/fcl_scene.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <mutex>

namespace underway {
namespace {

constexpr double kFlush_m = 1e-9;
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
        fcl(std::make_shared<fcl::Boxd>(x.length(), y.length(), z.length() + 2.0 * kFlush_m)) {}
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

class FclScene::Base {
 public:
  explicit Base(Obstacles obstacles) : obstacles_(std::move(obstacles)) {}

  [[nodiscard]] const Obstacles& obstacles() const { return obstacles_; }

  /// Whether an object touches an obstacle that is not among those to pass over.
  bool touches(Object& query, const std::unordered_set<const Obstacle*>& passed_over) const {
    std::call_once(once_, [this] { build(); });
    Walk walk{&query, this, &passed_over, false};
    manager_.collide(&query, &walk, step);
    return walk.found;
  }

 private:
  /// What a walk through the tree carries along.
  struct Walk {
    const Object* query;  // FCL does not promise which of two objects is the query
    const Base* base;
    const std::unordered_set<const Obstacle*>* passed_over;
    bool found;
  };

  static bool step(Object* a, Object* b, void* data) {
    Walk& walk = *static_cast<Walk*>(data);
    const Object& obstacle = a == walk.query ? *b : *a;
    if (!walk.passed_over->empty()) {
      const auto i = static_cast<std::size_t>(&obstacle - walk.base->objects_.data());
      if (walk.passed_over->contains(walk.base->obstacles_.pointer(i).get())) return false;
    }
    walk.found = collide(*walk.query, obstacle);
    return walk.found;
  }

  void build() const {
    objects_.reserve(obstacles_.size());
    std::vector<Object*> all;
    for (const Obstacle& obstacle : obstacles_) {
      Object& object = objects_.emplace_back(objectOf(obstacle.box));
      all.push_back(&object);
    }
    manager_.registerObjects(all);
    manager_.setup();
  }

  Obstacles obstacles_;
  mutable std::once_flag once_;  // of building, by whoever asks first
  mutable std::vector<Object> objects_;
  mutable fcl::DynamicAABBTreeCollisionManagerd manager_;
};

FclScene::FclScene(Obstacles obstacles) : base_(std::make_shared<const Base>(std::move(obstacles))) {}

FclScene FclScene::changed(const Obstacles& after) const {
  FclScene result = *this;
  result.gone_.clear();
  result.come_ = nullptr;
  std::vector<Obstacle> come;
  std::size_t changes = 0;
  Obstacles::visitChanges(base_->obstacles(), after,
                          [&](const Obstacles::Pointer& was, const Obstacles::Pointer& is) {
                            if (++changes > kMostChanges) return;
                            if (was) result.gone_.insert(was.get());
                            if (is) come.push_back(*is);
                          });
  if (changes > kMostChanges) return FclScene(after);
  std::optional<std::string> no_twin;
  if (!come.empty()) result.come_ = std::make_shared<const Base>(Obstacles(std::move(come), no_twin));
  return result;
}

bool FclScene::touches(const FclBody& body) const {
  static const std::unordered_set<const Obstacle*> kNone;
  fcl::CollisionObjectd& query = body.object_->fcl;
  return base_->touches(query, gone_) || (come_ && come_->touches(query, kNone));
}

bool FclScene::touches(const Prism& box) const {
  FclBody body(box.x, box.y, box.z);
  body.place(box.frame);
  return touches(body);
}

bool FclScene::touches(Point center, double radius_m, Range z) const {
  static const std::unordered_set<const Obstacle*> kNone;
  const Vec3 at{center.x, center.y, 0.5 * (z.min + z.max)};
  Object query(std::make_shared<fcl::Cylinderd>(radius_m, z.length()), placed(at, rotation(OrientedBox{})));
  return base_->touches(query, gone_) || (come_ && come_->touches(query, kNone));
}

}  // namespace underway
