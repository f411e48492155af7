#pragma once

#include <memory>

#include "geometry/obstacles.hpp"
#include "geometry/sweep.hpp"

namespace underway::bench {

/// A box as FCL's own, made once and placed anywhere. A hair higher and lower than it says: one that ends
/// flush with an obstacle counts as touching here, as it does in the layers, however FCL rounds.
class FclBody {
 public:
  /// Ranges in the body frame, heights above the map frame's origin [m].
  FclBody(Range x, Range y, Range z);
  ~FclBody();
  FclBody(FclBody&&) noexcept;
  void place(const Pose& frame);

 private:
  friend class FclTree;
  struct Object;
  std::unique_ptr<Object> object_;
};

/// Obstacles in FCL's dynamic tree, as a user of FCL would hold them: what the collision engine is measured
/// against. Thread safety: const members may be called from any number of threads.
class FclTree {
 public:
  explicit FclTree(const Obstacles& obstacles);
  ~FclTree();
  FclTree(FclTree&&) noexcept;

  [[nodiscard]] bool touches(const FclBody& body) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace underway::bench
