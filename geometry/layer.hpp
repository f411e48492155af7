#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/convex.hpp"
#include "geometry/world.hpp"

namespace underway {

/// What a mode sees of the world: each obstacle cut to the mode's slab and projected to the floor, exactly.
/// Piece i belongs to obstacle i; it is empty when the obstacle does not reach into the slab.
class Layer {
 public:
  Layer(const World& world, Range slab);

  [[nodiscard]] Range slab() const { return slab_; }
  [[nodiscard]] ConvexView piece(std::size_t obstacle) const {
    return {corners_.data() + first_[obstacle], corners_.data() + first_[obstacle + 1]};
  }

 private:
  Range slab_;
  std::vector<Point> corners_;
  std::vector<std::uint32_t> first_;  // of each piece; one more at the end
};

/// The part of a box between two heights (closed), projected to the floor; empty when there is none.
[[nodiscard]] std::vector<Point> flattened(const OrientedBox& box, Range slab);

/// The lowest point of a box among those at or above a height and over a convex area of the floor; empty when
/// the box is nowhere there. Right as long as the box does not touch the area at exactly that height.
[[nodiscard]] std::optional<double> lowestAbove(const OrientedBox& box, ConvexView area, double height_m);

}  // namespace underway
