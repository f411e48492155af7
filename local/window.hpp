#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "geometry/pose.hpp"
#include "local/scan.hpp"

namespace underway {

/// A grid of what was seen lately, that slides along with the robot: 6.4 x 6.4 m in cells of 5 cm. What
/// slides out is forgotten. A cell remembers how often something was seen in it; beams that pass through it
/// take that back. Every tick a part of the beams is looked at for that, so time is bounded; allocates only
/// when made. Points are in any one frame that stands still: the map's, or that of dead reckoning.
class Window {
 public:
  static constexpr std::size_t kCells = 128;
  static constexpr double kCell_m = 0.05;
  static constexpr std::uint8_t kSure = 3;  ///< seen so often, something stands there
  static constexpr std::uint8_t kMost = 6;  ///< more is not counted

  Window();

  /// Moves along with the robot: it is in the middle, but for a cell.
  void slideTo(Point at);
  /// Something was seen at a point; outside the window it is passed over.
  void hit(Point at);
  /// Nothing stands between two points, but near the second: the cells between them are seen less, as far as
  /// the window's nearest edge. The floor is seen as far as the second.
  void pass(Point from, Point to);
  /// The floor in the cell of a point is known: a beam passed there, or the body stood on it.
  void markSeen(Point at);
  /// Whether something stands in the cell of a point.
  [[nodiscard]] bool isOccupied(Point at) const;
  /// From now on the occupied cells are known: whoever plans has been told of them.
  void markKnown();
  void clear();

  /// Calls `visit(at, is_known)` for each occupied cell within a distance of a point along both axes, with
  /// the mean of what was seen in it.
  template <class Visit>
  void visitOccupied(Point round, double reach_m, const Visit& visit) const;

  /// Calls `visit(middle)` for each cell within a distance of a point along both axes whose floor is not
  /// seen; all of them must lie in the window.
  template <class Visit>
  void visitUnseen(Point round, double reach_m, const Visit& visit) const;

 private:
  static constexpr auto kWide = static_cast<std::int64_t>(kCells);
  static constexpr std::int64_t kWord = 8;  // cells that are looked at together
  struct Place {
    std::int64_t x;
    std::int64_t y;
  };
  /// Of what was seen in a cell, from its corner: surer than the cell.
  struct Mean {
    float x_m = 0.0F;
    float y_m = 0.0F;
  };
  [[nodiscard]] static Place placeOf(Point at) {
    return {static_cast<std::int64_t>(std::floor(at.x * (1.0 / kCell_m))),
            static_cast<std::int64_t>(std::floor(at.y * (1.0 / kCell_m)))};
  }
  [[nodiscard]] bool isInside(Place place) const {
    return place.x >= corner_.x && place.y >= corner_.y && place.x < corner_.x + kWide &&
           place.y < corner_.y + kWide;
  }
  /// Modulo kCells, a power of two, also of what is negative.
  [[nodiscard]] static std::size_t wrapped(std::int64_t at) {
    return static_cast<std::size_t>(at) & (kCells - 1);
  }
  [[nodiscard]] static std::size_t indexOf(Place place) {
    return wrapped(place.y) * kCells + wrapped(place.x);
  }
  /// Of eight cells, of which the first is at a multiple of eight: whether anything was seen in them, and
  /// whether all their floor was.
  [[nodiscard]] bool isAnySeen(Place first) const { return eightOf(hits_, first) != 0; }
  [[nodiscard]] bool isAllFloorSeen(Place first) const {
    return eightOf(is_seen_, first) == 0x0101010101010101U;
  }
  [[nodiscard]] static std::uint64_t eightOf(const std::vector<std::uint8_t>& cells, Place first) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, &cells[indexOf(first)], sizeof eight);
    return eight;
  }
  void forget(std::size_t index);
  /// From a point inside to the nearest edge; negative outside [m].
  [[nodiscard]] double toEdge(Point from) const;

  // A torus: a cell's index is its place modulo kCells. Bytes, because most cells are asked no more than
  // whether anything was seen in them.
  std::vector<std::uint8_t> hits_;
  std::vector<std::uint8_t> is_known_;
  std::vector<std::uint8_t> is_seen_;  // its floor
  std::vector<Mean> means_;            // of those with hits
  Place corner_{-kWide / 2, -kWide / 2};
};

template <class Visit>
void Window::visitOccupied(Point round, double reach_m, const Visit& visit) const {
  Place low = placeOf({round.x - reach_m, round.y - reach_m});
  Place high = placeOf({round.x + reach_m, round.y + reach_m});
  low = {std::max(low.x, corner_.x), std::max(low.y, corner_.y)};
  high = {std::min(high.x, corner_.x + kWide - 1), std::min(high.y, corner_.y + kWide - 1)};
  for (std::int64_t y = low.y; y <= high.y; ++y)
    for (std::int64_t word = low.x & -kWord; word <= high.x; word += kWord) {
      if (!isAnySeen({word, y})) continue;
      for (std::int64_t x = std::max(word, low.x); x <= std::min(word + kWord - 1, high.x); ++x) {
        const std::size_t i = indexOf({x, y});
        if (hits_[i] < kSure) continue;
        visit(Point{static_cast<double>(x) * kCell_m + means_[i].x_m,
                    static_cast<double>(y) * kCell_m + means_[i].y_m},
              is_known_[i] != 0);
      }
    }
}

template <class Visit>
void Window::visitUnseen(Point round, double reach_m, const Visit& visit) const {
  const Place low = placeOf({round.x - reach_m, round.y - reach_m});
  const Place high = placeOf({round.x + reach_m, round.y + reach_m});
  for (std::int64_t y = low.y; y <= high.y; ++y)
    for (std::int64_t word = low.x & -kWord; word <= high.x; word += kWord) {
      if (isAllFloorSeen({word, y})) continue;
      for (std::int64_t x = std::max(word, low.x); x <= std::min(word + kWord - 1, high.x); ++x)
        if (is_seen_[indexOf({x, y})] == 0)
          visit(Point{(static_cast<double>(x) + 0.5) * kCell_m, (static_cast<double>(y) + 0.5) * kCell_m});
    }
}

/// Traps become virtual obstacles (Brooks 2017, 7.4): discs that shorten the beams that meet them, so that
/// GODZILA keeps away from where it was trapped. A disc that the robot stands in is not there until it has
/// left it. The oldest gives way to the newest; what is further than the window reaches is forgotten.
class VirtualObstacles {
 public:
  void add(Point at, double radius_m);
  /// The scan as it would be if the discs stood there, from a pose in their frame.
  void shorten(Scan& scan, const Pose& from);
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t kMost = 8;
  struct Disc {
    Point at;
    double radius_m = 0.0;
  };
  std::array<Disc, kMost> discs_{};
  std::size_t size_ = 0;
  std::size_t oldest_ = 0;
};

}  // namespace underway
