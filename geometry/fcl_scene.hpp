#pragma once

#include <memory>

#include "geometry/fcl_shapes.hpp"
#include "geometry/obstacles.hpp"
#include "geometry/region_grid.hpp"

namespace underway {

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
