#include "local/window.hpp"

#include <cmath>

namespace underway {
namespace {

constexpr auto kWide = static_cast<std::int64_t>(Window::kCells);
constexpr float kLeastGain = 0.05F;  // of a hit on a cell's mean

}  // namespace

Window::Place Window::placeOf(Point at) {
  return {static_cast<std::int64_t>(std::floor(at.x / kCell_m)),
          static_cast<std::int64_t>(std::floor(at.y / kCell_m))};
}

void Window::slideTo(Point at) {
  const Place middle = placeOf(at);
  const Place corner{middle.x - kWide / 2, middle.y - kWide / 2};
  if (std::abs(corner.x - corner_.x) >= kWide || std::abs(corner.y - corner_.y) >= kWide) {
    clear();
    corner_ = corner;
    return;
  }
  // Columns and rows that slide in take the places of those that slide out.
  while (corner_.x < corner.x) forgetColumn(corner_.x++);
  while (corner_.x > corner.x) forgetColumn(--corner_.x);
  while (corner_.y < corner.y) forgetRow(corner_.y++);
  while (corner_.y > corner.y) forgetRow(--corner_.y);
}

void Window::forgetColumn(std::int64_t x) {
  for (std::size_t row = 0; row < kCells; ++row) cells_[row * kCells + wrapped(x)] = {};
}

void Window::forgetRow(std::int64_t y) {
  std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(wrapped(y) * kCells), kCells, Cell{});
}

void Window::hit(Point at) {
  const Place place = placeOf(at);
  if (!isInside(place)) return;
  Cell& cell = cells_[indexOf(place)];
  if (cell.hits < kMost) ++cell.hits;
  const Point corner{static_cast<double>(place.x) * kCell_m, static_cast<double>(place.y) * kCell_m};
  const float gain = cell.hits < kMost ? 1.0F / static_cast<float>(cell.hits) : kLeastGain;
  cell.x_m += gain * (static_cast<float>(at.x - corner.x) - cell.x_m);
  cell.y_m += gain * (static_cast<float>(at.y - corner.y) - cell.y_m);
}

bool Window::isOccupied(Point at) const {
  const Place place = placeOf(at);
  return isInside(place) && cells_[indexOf(place)].hits >= kSure;
}

void Window::markKnown() {
  for (Cell& cell : cells_) cell.is_known = cell.hits >= kSure;
}

void Window::pass(Point from, Point to) {
  constexpr double kShort_m = kCell_m;  // of the end: what stands there may reach nearer
  const double range = distance(from, to);
  if (!(range > kShort_m)) return;
  const Point step{kCell_m * (to.x - from.x) / range, kCell_m * (to.y - from.y) / range};
  const auto steps = static_cast<int>((range - kShort_m) / kCell_m);
  Point at = from;
  for (int k = 0; k <= steps; ++k, at.x += step.x, at.y += step.y) {
    const Place place = placeOf(at);
    if (!isInside(place)) return;
    Cell& cell = cells_[indexOf(place)];
    if (cell.hits > 0) --cell.hits;
  }
}

void VirtualObstacles::add(Point at, double radius_m) {
  if (size_ < kMost) {
    discs_[size_++] = {at, radius_m};
    return;
  }
  discs_[oldest_] = {at, radius_m};
  oldest_ = (oldest_ + 1) % kMost;
}

void VirtualObstacles::shorten(Scan& scan, const Pose& from) {
  constexpr double kReach_m = 0.5 * static_cast<double>(Window::kCells) * Window::kCell_m;
  for (std::size_t k = 0; k < size_; ++k) {
    const double range = distance(discs_[k].at, from.position());
    const double radius = discs_[k].radius_m;
    if (range > kReach_m || range <= radius + 0.3) continue;
    const double middle =
        normalizedAngle(std::atan2(discs_[k].at.y - from.y, discs_[k].at.x - from.x) - from.yaw);
    const double half = std::asin(radius / range);
    const double first = (middle - half - scan.beams.first_rad) / scan.beams.step_rad;
    for (auto i = static_cast<std::size_t>(std::max(std::ceil(first), 0.0)); i < scan.ranges_m.size(); ++i) {
      const double off = scan.beams.bearing(i) - middle;
      if (off >= half) break;
      const double across = range * std::sin(off);
      const double hit = range * std::cos(off) - std::sqrt(radius * radius - across * across);
      scan.ranges_m[i] = std::min(scan.ranges_m[i], static_cast<float>(hit));
    }
  }
}

}  // namespace underway
