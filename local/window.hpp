#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/pose.hpp"
#include "local/scan.hpp"
#include "local/sliding_grid.hpp"

namespace underway {

/// A grid of what was seen lately, that slides along with the robot: 6.4 x 6.4 m in cells of 5 cm. What
/// slides out is forgotten. A cell remembers how often something was seen in it; beams that pass through that
/// take it back. Time is bounded; allocates only when made. Points are in any one frame that stands still:
/// the map's, or that of dead reckoning.
class Window {
 public:
  static constexpr std::size_t kCells = 128;
  using Grid = SlidingGrid<kCells, 50>;
  static constexpr double kCell_m = Grid::kCell_m;
  static constexpr std::uint8_t kSure = 3;  ///< seen so often, something stands there
  static constexpr std::uint8_t kMost = 6;  ///< more is not counted

  Window();

  /// Moves along with the robot: it is in the middle, but for a cell.
  void slideTo(Point at);
  /// Something was seen at a point; outside the window it is passed over.
  void hit(Point at);
  /// Nothing stands where the beams of a scan pass, which was taken from a pose. What was seen nearer than
  /// `far_m`, by its mean, is seen once less where the three beams nearest to that end more than kShort_m
  /// behind it. Each call looks at half of the cells, and the next at the other half.
  void takeBack(const Scan& scan, const Pose& from, double far_m);
  static constexpr double kShort_m = 0.02;
  /// Whether something stands in the cell of a point.
  [[nodiscard]] bool isOccupied(Point at) const;
  /// From now on the occupied cells are known: whoever plans has been told of them.
  void markKnown();

  /// Calls `visit(at, is_known)` for each occupied cell within a distance of a point along both axes, with
  /// the mean of what was seen in it.
  template <class Visit>
  void visitOccupied(Point about, double reach_m, const Visit& visit) const;
  /// Calls `visit(at)` for points that outline what was seen in each of those cells, kOutline_m apart at
  /// most: as far as it spreads from its mean along both of its principal axes. Of a face they lie along it,
  /// to its end; of a corner one is at its tip. `sigma_m` is the noise of what sees, from near `about`, along
  /// its view: so much of the spread is none.
  template <class Visit>
  void visitOutlines(Point about, double reach_m, double sigma_m, const Visit& visit) const;
  static constexpr double kOutline_m = 0.0125;

 private:
  /// Of what was seen in a cell, from its corner: surer than the cell.
  struct Mean {
    float x_m = 0.0F;
    float y_m = 0.0F;
  };
  /// How it spreads about that: covariances.
  struct Spread {
    float xx_m2 = 0.0F;
    float xy_m2 = 0.0F;
    float yy_m2 = 0.0F;
  };
  /// From the mean of an even spread to its ends along the principal axes.
  struct Extents {
    double length_m;  // of the longer
    Point longer;
    Point shorter;
  };
  /// `view`: a unit vector.
  [[nodiscard]] static Extents extentsOf(const Spread& spread, Point view, double sigma_m);
  /// Of eight cells.
  [[nodiscard]] static bool isAnyHit(std::uint64_t eight) { return eight != 0; }
  [[nodiscard]] Point meanOf(std::size_t i, Grid::Place place) const {
    const Point corner = Grid::cornerOf(place);
    return {corner.x + means_[i].x_m, corner.y + means_[i].y_m};
  }
  /// Calls `visit(index, mean)` for each occupied cell.
  template <class Visit>
  void visitCells(Point about, double reach_m, const Visit& visit) const;

  Grid grid_;
  std::vector<std::uint8_t> hits_;  // bytes: most cells are asked no more than whether there are any
  std::vector<std::uint8_t> is_known_;
  std::vector<Mean> means_;  // of those with hits
  std::vector<Spread> spreads_;
  std::array<std::uint64_t, Grid::kCount / 64> may_have_hits_{};  // a bit for each cell; others have none
  std::size_t half_ = 0;  // of those words, the odd or the even ones: looked at next for what to take back
};

template <class Visit>
void Window::visitCells(Point about, double reach_m, const Visit& visit) const {
  grid_.visitIn(round(about, reach_m), hits_, isAnyHit, [&](std::size_t i, Grid::Place place) {
    if (hits_[i] >= kSure) visit(i, meanOf(i, place));
  });
}

template <class Visit>
void Window::visitOccupied(Point about, double reach_m, const Visit& visit) const {
  visitCells(about, reach_m, [&](std::size_t i, Point mean) { visit(mean, is_known_[i] != 0); });
}

template <class Visit>
void Window::visitOutlines(Point about, double reach_m, double sigma_m, const Visit& visit) const {
  visitCells(about, reach_m, [&](std::size_t i, Point mean) {
    const double range_m = std::max(distance(mean, about), 1e-6);
    const Point view{(mean.x - about.x) / range_m, (mean.y - about.y) / range_m};
    const auto [length_m, longer, shorter] = extentsOf(spreads_[i], view, sigma_m);
    const auto steps = static_cast<int>(2.0 * length_m / kOutline_m) + 1;
    for (int k = 0; k <= steps; ++k) {
      const double share = 2.0 * k / steps - 1.0;
      visit(Point{mean.x + share * longer.x, mean.y + share * longer.y});
    }
    visit(Point{mean.x + shorter.x, mean.y + shorter.y});
    visit(Point{mean.x - shorter.x, mean.y - shorter.y});
  });
}

/// Traps become virtual obstacles (Brooks 2017, 7.4): discs that shorten the beams that meet them, so that
/// GODZILA keeps away from where it was trapped. A disc that the robot stands in is not there until it has
/// left it. The oldest gives way to the newest; what is further than the window reaches counts for nothing.
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
