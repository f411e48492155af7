#include "geometry/fcl_scene.hpp"

#include <algorithm>
#include <mutex>
#include <unordered_set>

namespace underway {
namespace {

constexpr double kRounding_m = 1e-6;      // of bounding boxes; they only have to be large enough
constexpr std::size_t kMostChanges = 64;  // that are carried beside a grid

Region regionOf(const OrientedBox& box) {
  const auto vertices = corners(box);
  Region region = Region::between({vertices[0].x, vertices[0].y}, {vertices[0].x, vertices[0].y});
  for (const Vec3& vertex : vertices) region = region.joint({vertex.x, vertex.y, vertex.x, vertex.y});
  return region.grown(kRounding_m);
}

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
