#include "geometry/fcl_scene.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <unordered_set>

namespace underway {
namespace {

constexpr double kHair_m = 1e-9;
constexpr double kRounding_m = 1e-6;      // of bounding boxes; they only have to be large enough
constexpr std::size_t kMostChanges = 64;  // that are carried beside a grid

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

Region regionOf(const OrientedBox& box) {
  const auto vertices = corners(box);
  Region region = Region::between({vertices[0].x, vertices[0].y}, {vertices[0].x, vertices[0].y});
  for (const Vec3& vertex : vertices) region = region.joint({vertex.x, vertex.y, vertex.x, vertex.y});
  return region.grown(kRounding_m);
}

}  // namespace

struct FclShapes::Shapes {
  std::vector<Object> objects;
};

namespace {

bool collide(const Object& a, const Object& b) {
  static const fcl::CollisionRequestd kBoolean(1, false);
  if (!a.getAABB().overlap(b.getAABB())) return false;
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, kBoolean, result) > 0;
}

Object objectOf(const Prism& box) {
  const double c = std::cos(box.frame.yaw);
  const double s = std::sin(box.frame.yaw);
  const Point middle{0.5 * (box.x.min + box.x.max), 0.5 * (box.y.min + box.y.max)};
  fcl::Transform3d at = fcl::Transform3d::Identity();
  at.linear() << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  at.translation() << box.frame.x + c * middle.x - s * middle.y, box.frame.y + s * middle.x + c * middle.y,
      0.5 * (box.z.min + box.z.max);
  return {std::make_shared<fcl::Boxd>(box.x.length(), box.y.length(), box.z.length() + 2.0 * kHair_m), at};
}

Object cylinderAt(Point center, double radius_m, Range z) {
  const Vec3 at{center.x, center.y, 0.5 * (z.min + z.max)};
  return {std::make_shared<fcl::Cylinderd>(radius_m, z.length()), placed(at, rotation(OrientedBox{}))};
}

/// All points within a distance of a box: the box grown along either axis, and a cylinder round each edge.
std::vector<Object> roundedBox(const Prism& box, double distance_m) {
  std::vector<Object> parts{objectOf(Prism{box.frame, box.x.grown(distance_m), box.y, box.z}),
                            objectOf(Prism{box.frame, box.x, box.y.grown(distance_m), box.z})};
  for (const Point corner : box.footprint()) parts.push_back(cylinderAt(corner, distance_m, box.z));
  return parts;
}

}  // namespace

FclShapes::FclShapes(std::vector<Obstacles::Pointer> obstacles) {
  auto shapes = std::make_unique<Shapes>();
  shapes->objects.reserve(obstacles.size());
  for (const Obstacles::Pointer& obstacle : obstacles) shapes->objects.push_back(objectOf(obstacle->box));
  shapes_ = std::move(shapes);
}
FclShapes::~FclShapes() = default;
FclShapes::FclShapes(FclShapes&&) noexcept = default;

bool FclShapes::touches(const Prism& box) const {
  if (shapes_->objects.empty()) return false;
  const Object query = objectOf(box);
  return std::any_of(shapes_->objects.begin(), shapes_->objects.end(),
                     [&](const Object& object) { return collide(query, object); });
}

bool FclShapes::comeWithin(const Prism& box, double distance_m) const {
  if (distance_m <= 0.0) return touches(box);
  if (shapes_->objects.empty()) return false;
  const Object grown = objectOf(box.grown(distance_m));  // with square corners: what it misses is further
  std::vector<Object> rounded;
  for (const Object& object : shapes_->objects) {
    if (!collide(grown, object)) continue;
    if (rounded.empty()) rounded = roundedBox(box, distance_m);
    if (std::any_of(rounded.begin(), rounded.end(),
                    [&](const Object& part) { return collide(part, object); }))
      return true;
  }
  return false;
}

namespace {

/// A grid over the bounding boxes of some obstacles.
class Plot {
 public:
  explicit Plot(std::shared_ptr<const Obstacles> obstacles) : obstacles_(std::move(obstacles)) {
    std::vector<Region> regions;
    regions.reserve(obstacles_->size());
    for (const Obstacle& obstacle : *obstacles_) regions.push_back(regionOf(obstacle.box));
    grid_ = RegionGrid(std::move(regions));
  }

  [[nodiscard]] const Obstacles& obstacles() const { return *obstacles_; }
  /// Their indices, each once, ascending.
  [[nodiscard]] std::vector<std::uint32_t> in(const Region& region) const {
    std::vector<std::uint32_t> found;
    grid_.visit(region, [&](std::uint32_t index) { found.push_back(index); });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  std::shared_ptr<const Obstacles> obstacles_;
  RegionGrid grid_;
};

}  // namespace

/// The shapes of one revision: a grid, which may be an earlier revision's, and what came and went since.
class FclScene::Stock {
 public:
  /// `earlier` is the grid that was made last; null if none was.
  Stock(std::shared_ptr<const Obstacles> obstacles, std::shared_ptr<const Plot> earlier)
      : obstacles_(std::move(obstacles)), plot_(std::move(earlier)) {}

  /// The grid for a later revision to use.
  [[nodiscard]] std::shared_ptr<const Plot> plot() const {
    const std::lock_guard lock(making_);
    return plot_;
  }

  [[nodiscard]] std::vector<Obstacles::Pointer> in(const Region& region) const {
    std::call_once(once_, [this] { make(); });
    std::vector<Obstacles::Pointer> found;
    for (const std::uint32_t index : plot_->in(region)) {
      const Obstacles::Pointer& obstacle = plot_->obstacles().pointer(index);
      if (gone_.empty() || !gone_.contains(obstacle.get())) found.push_back(obstacle);
    }
    for (const Obstacles::Pointer& obstacle : come_)
      if (regionOf(obstacle->box).overlaps(region)) found.push_back(obstacle);
    return found;
  }

 private:
  void make() const {
    const std::lock_guard lock(making_);
    const auto changes =
        plot_ ? Obstacles::changes(plot_->obstacles(), *obstacles_) : std::vector<Obstacles::Change>();
    if (!plot_ || changes.size() > kMostChanges) {
      plot_ = std::make_shared<const Plot>(obstacles_);
      return;
    }
    for (const auto& [before, after] : changes) {
      if (before) gone_.insert(before.get());
      if (after) come_.push_back(after);
    }
  }

  std::shared_ptr<const Obstacles> obstacles_;
  mutable std::once_flag once_;  // of making, by whoever asks first
  mutable std::mutex making_;    // guards plot_ until it is made
  mutable std::shared_ptr<const Plot> plot_;
  mutable std::unordered_set<const Obstacle*> gone_;  // of the grid's
  mutable std::vector<Obstacles::Pointer> come_;
};

FclScene::FclScene(std::shared_ptr<const Obstacles> obstacles)
    : stock_(std::make_shared<const Stock>(std::move(obstacles), nullptr)) {}
FclScene::FclScene(std::shared_ptr<const Stock> stock) : stock_(std::move(stock)) {}

FclScene FclScene::changed(std::shared_ptr<const Obstacles> after) const {
  return FclScene(std::make_shared<const Stock>(std::move(after), stock_->plot()));
}

FclShapes FclScene::shapesIn(const Region& region) const { return FclShapes(stock_->in(region)); }

}  // namespace underway
