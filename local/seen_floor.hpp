#pragma once

#include <cstdint>
#include <vector>

#include "local/sliding_grid.hpp"

namespace underway {

/// The floor round the robot that was seen lately, 6.4 x 6.4 m in cells of 2.5 cm that slide along with it: a
/// beam passed there, or the body stood there. What slides out is forgotten. Allocates only when made. Points
/// are in any one frame that stands still.
class SeenFloor {
 public:
  using Grid = SlidingGrid<256, 25>;
  static constexpr double kCell_m = Grid::kCell_m;
  static constexpr double kShort_m = 0.04;  ///< of a beam's end: what it ends on may begin so much before
  static constexpr double kFar_m = 1.2;     ///< what is further away is seen again before it matters

  SeenFloor();

  /// Moves along with the robot: it is in the middle, but for a cell.
  void slideTo(Point at);
  /// A beam passed from a point to another.
  void pass(Point from, Point to);
  /// The cell of a point is known.
  void mark(Point at);

  /// Calls `visit(middle)` for each cell in an extent that was not seen, as far as they lie inside.
  template <class Visit>
  void visitUnseen(const Extent& extent, const Visit& visit) const;

 private:
  Grid grid_;
  std::vector<std::uint8_t> is_seen_;  // bytes: eight of them are looked at together
};

template <class Visit>
void SeenFloor::visitUnseen(const Extent& extent, const Visit& visit) const {
  constexpr std::uint64_t kAllSeen = 0x0101010101010101U;
  const auto is_any_unseen = [](std::uint64_t eight) { return eight != kAllSeen; };
  grid_.visitIn(extent, is_seen_, is_any_unseen, [&](std::size_t i, Grid::Place place) {
    if (is_seen_[i] != 0) return;
    const Point corner = Grid::cornerOf(place);
    visit(Point{corner.x + 0.5 * kCell_m, corner.y + 0.5 * kCell_m});
  });
}

}  // namespace underway
