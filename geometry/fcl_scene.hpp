#pragma once

#include <memory>

#include "geometry/obstacles.hpp"
#include "geometry/sweep.hpp"

namespace underway {

/// A box as FCL's own, made once and placed anywhere.
class FclBody {
 public:
  /// Ranges in the body frame, heights above the map frame's origin [m].
  FclBody(Range x, Range y, Range z);
  ~FclBody();
  FclBody(FclBody&&) noexcept;
  void place(const Pose& frame);

 private:
  friend class FclScene;
  struct Object;
  std::unique_ptr<Object> object_;
};

/// The world's source shapes in FCL's dynamic tree, made when it is first asked. Asked for booleans only: its
/// distances can overestimate. After a change the tree stays as it was: what is gone is passed over, what
/// came is in a second tree, until that is so much that a new tree is due.
///
/// Thread safety: const members may be called from any number of threads.
class FclScene {
 public:
  explicit FclScene(std::shared_ptr<const Obstacles> obstacles);
  [[nodiscard]] FclScene changed(std::shared_ptr<const Obstacles> after) const;

  [[nodiscard]] bool touches(const FclBody& body) const;
  /// Whether a box touches any obstacle.
  [[nodiscard]] bool touches(const Prism& box) const;
  /// Whether an upright cylinder touches any obstacle.
  [[nodiscard]] bool touches(Point center, double radius_m, Range z) const;

 private:
  class Forest;
  explicit FclScene(std::shared_ptr<const Forest> forest);
  std::shared_ptr<const Forest> forest_;
};

}  // namespace underway
