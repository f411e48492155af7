#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "geometry/pose.hpp"
#include "local/extent.hpp"

namespace underway {

/// Where the cells of a square grid lie that slides along with a robot: a torus, in which a cell's index is
/// its place modulo the number of cells. Points are in any one frame that stands still. What the cells hold
/// is the owner's, in arrays by index; `kCells`, to a side, is a power of two.
template <std::size_t kCells, int kCell_mm>
class SlidingGrid {
 public:
  static constexpr double kCell_m = 1e-3 * kCell_mm;
  static constexpr std::size_t kCount = kCells * kCells;
  struct Place {
    std::int64_t x;
    std::int64_t y;
  };

  [[nodiscard]] static Place placeOf(Point at) {
    return {roundedDown(at.x * (1.0 / kCell_m)), roundedDown(at.y * (1.0 / kCell_m))};
  }
  /// The corner of a cell with the least coordinates.
  [[nodiscard]] static Point cornerOf(Place place) {
    return {static_cast<double>(place.x) * kCell_m, static_cast<double>(place.y) * kCell_m};
  }
  [[nodiscard]] static std::size_t indexOf(Place place) {
    return wrapped(place.y) * kCells + wrapped(place.x);
  }
  [[nodiscard]] bool isInside(Place place) const {
    return place.x >= first_.x && place.y >= first_.y && place.x < first_.x + kWide &&
           place.y < first_.y + kWide;
  }
  /// From a point inside to the nearest edge; negative outside [m].
  [[nodiscard]] double toEdge(Point from) const {
    constexpr double kHalf_m = 0.5 * static_cast<double>(kCells) * kCell_m;
    const Point corner = cornerOf(first_);
    return kHalf_m - std::max(std::abs(from.x - corner.x - kHalf_m), std::abs(from.y - corner.y - kHalf_m));
  }

  /// Moves along: a point comes to lie in the middle, but for a cell. Calls `forget(index)` for each cell
  /// that is another from now on.
  template <class Forget>
  void slideTo(Point at, const Forget& forget) {
    const Place middle = placeOf(at);
    const Place first{middle.x - kWide / 2, middle.y - kWide / 2};
    if (std::abs(first.x - first_.x) >= kWide || std::abs(first.y - first_.y) >= kWide) {
      first_ = first;
      for (std::size_t i = 0; i < kCount; ++i) forget(i);
      return;
    }
    const auto forget_column = [&](std::int64_t x) {
      for (std::size_t row = 0; row < kCells; ++row) forget(row * kCells + wrapped(x));
    };
    const auto forget_row = [&](std::int64_t y) {
      for (std::size_t column = 0; column < kCells; ++column) forget(wrapped(y) * kCells + column);
    };
    while (first_.x < first.x) forget_column(first_.x++);
    while (first_.x > first.x) forget_column(--first_.x);
    while (first_.y < first.y) forget_row(first_.y++);
    while (first_.y > first.y) forget_row(--first_.y);
  }

  /// Calls `visit(index)` for cells along a ray from a point to another and on, a cell's length apart, as far
  /// as `far_m` from the first: which must lie inside.
  template <class Visit>
  static void visitAlong(Point from, Point to, double far_m, const Visit& visit) {
    // Places in fixed point, modulo the grid, so that no step has to be rounded down or wrapped: the grid is
    // as wide as a word's numbers.
    constexpr int kFraction = 32 - std::countr_zero(kCells);
    constexpr double kUnits = static_cast<double>(std::uint64_t{1} << kFraction) / kCell_m;
    const auto fixed = [](double m) { return static_cast<std::uint32_t>(roundedDown(kUnits * m)); };
    const double range_m = distance(from, to);
    if (!(range_m > 0.0 && far_m > 0.0)) return;
    const double share = kCell_m / range_m;
    const std::uint32_t step_x = fixed(share * (to.x - from.x));
    const std::uint32_t step_y = fixed(share * (to.y - from.y));
    std::uint32_t x = fixed(from.x);
    std::uint32_t y = fixed(from.y);
    const auto steps = static_cast<int>(far_m / kCell_m);
    for (int k = 0; k <= steps; ++k, x += step_x, y += step_y)
      visit((y >> kFraction) * kCells + (x >> kFraction));
  }

  /// Calls `visit(index, place)` for the cells in an extent, as far as they are inside; eight of them that
  /// lie side by side are left out at once where `mayMatter` says so of their bytes.
  template <class MayMatter, class Visit>
  void visitIn(const Extent& extent, const std::vector<std::uint8_t>& bytes, const MayMatter& mayMatter,
               const Visit& visit) const {
    Place low = placeOf({extent.x.min, extent.y.min});
    Place high = placeOf({extent.x.max, extent.y.max});
    low = {std::max(low.x, first_.x), std::max(low.y, first_.y)};
    high = {std::min(high.x, first_.x + kWide - 1), std::min(high.y, first_.y + kWide - 1)};
    for (std::int64_t y = low.y; y <= high.y; ++y)
      for (std::int64_t word = low.x & -kWord; word <= high.x; word += kWord) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &bytes[indexOf({word, y})], sizeof eight);
        if (!mayMatter(eight)) continue;
        for (std::int64_t x = std::max(word, low.x); x <= std::min(word + kWord - 1, high.x); ++x)
          visit(indexOf({x, y}), Place{x, y});
      }
  }

  /// The place of the cell with an index.
  [[nodiscard]] Place placeAt(std::size_t index) const {
    const auto x = static_cast<std::int64_t>(index % kCells);
    const auto y = static_cast<std::int64_t>(index / kCells);
    return {first_.x + ((x - first_.x) & (kWide - 1)), first_.y + ((y - first_.y) & (kWide - 1))};
  }

 private:
  static constexpr auto kWide = static_cast<std::int64_t>(kCells);
  static constexpr std::int64_t kWord = 8;  // cells that are looked at together
  static_assert((kCells & (kCells - 1)) == 0 && kCells % kWord == 0);

  /// As std::floor, which is a call on plain processors.
  [[nodiscard]] static std::int64_t roundedDown(double x) {
    const auto towards_zero = static_cast<std::int64_t>(x);
    return towards_zero - (x < static_cast<double>(towards_zero) ? 1 : 0);
  }
  [[nodiscard]] static std::size_t wrapped(std::int64_t at) {
    return static_cast<std::size_t>(at) & (kCells - 1);  // also of what is negative
  }

  Place first_{-kWide / 2, -kWide / 2};
};

}  // namespace underway
