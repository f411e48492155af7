#pragma once

#include <memory>
#include <vector>

#include "geometry/obstacles.hpp"
#include "geometry/sweep.hpp"

namespace underway {

/// Some of a world's source shapes as FCL's own, to be asked for booleans only: FCL's distances can
/// overestimate. Boxes that ask are taken a hair higher and lower than they say: one that ends flush with an
/// obstacle counts as touching, as it does in the layers, however FCL rounds.
///
/// Thread safety: const members may be called from any number of threads.
class FclShapes {
 public:
  explicit FclShapes(const std::vector<Obstacles::Pointer>& obstacles);
  ~FclShapes();
  FclShapes(FclShapes&&) noexcept;

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] const OrientedBox& box(std::size_t i) const;

  /// Whether any of them comes within a distance of a box in the plane, Euclidean; within 0: touches it.
  [[nodiscard]] bool comeWithin(const Prism& box, double distance_m) const;
  /// Whether the i-th does.
  [[nodiscard]] bool comesWithin(std::size_t i, const Prism& box, double distance_m) const;

 private:
  struct Shapes;
  std::unique_ptr<const Shapes> shapes_;
};

/// The same of two upright boxes.
[[nodiscard]] bool comeWithin(const Prism& a, const Prism& b, double distance_m);

}  // namespace underway
