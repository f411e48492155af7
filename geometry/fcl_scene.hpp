#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/obstacles.hpp"
#include "geometry/region_grid.hpp"
#include "geometry/sweep.hpp"

namespace underway {

/// Some of a world's source shapes as FCL's own, to be asked for booleans only: FCL's distances can
/// overestimate. For one thread.
class FclShapes {
 public:
  explicit FclShapes(std::vector<Obstacles::Pointer> obstacles);
  ~FclShapes();
  FclShapes(FclShapes&&) noexcept;

  /// Whether a box touches any of them. It is taken a hair higher and lower than it says: one that ends flush
  /// with an obstacle counts as touching, as it does in the layers, however FCL rounds.
  [[nodiscard]] bool touches(const Prism& box) const;
  /// Whether any of them comes within a distance of a box in the plane, Euclidean.
  [[nodiscard]] bool comeWithin(const Prism& box, double distance_m) const;

 private:
  struct Shapes;
  std::unique_ptr<const Shapes> shapes_;
};

/// The world's source shapes, to pick some for FCL. Which may matter somewhere is told by a plain grid over
/// their bounding boxes, made when it is first asked: nothing here is shared with the layers. After a change
/// the grid stays as it was, and what is gone and what came is kept beside it, until that is so much that a
/// new one is due.
///
/// Thread safety: const members may be called from any number of threads.
class FclScene {
 public:
  explicit FclScene(std::shared_ptr<const Obstacles> obstacles);
  [[nodiscard]] FclScene changed(std::shared_ptr<const Obstacles> after) const;

  /// All obstacles whose bounding boxes overlap a region.
  [[nodiscard]] FclShapes shapesIn(const Region& region) const;

 private:
  class Stock;
  explicit FclScene(std::shared_ptr<const Stock> stock);
  std::shared_ptr<const Stock> stock_;
};

}  // namespace underway
