#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "geometry/sweep.hpp"
#include "geometry/world.hpp"

namespace underway {

/// The world's source shapes in FCL's dynamic tree. Asked for booleans only: its distances can overestimate.
/// Thread safety: const members may be called from any number of threads.
class FclScene {
 public:
  explicit FclScene(const World& world);
  ~FclScene();
  FclScene(const FclScene&) = delete;
  FclScene& operator=(const FclScene&) = delete;

  /// Gets an obstacle's index; returns true to stop looking.
  using Visit = std::function<bool(std::size_t)>;

  /// Whether a box touches any obstacle.
  [[nodiscard]] bool touches(const Prism& box) const;
  /// Whether an upright cylinder touches any obstacle.
  [[nodiscard]] bool touches(Point center, double radius_m, Range z) const;
  /// Visits every obstacle a box touches.
  void visitTouched(const Prism& box, const Visit& visit) const;
  /// Visits every obstacle whose axis-aligned box meets an axis-aligned box.
  void visitNear(Range x, Range y, Range z, const Visit& visit) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace underway
