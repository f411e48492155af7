#include "local/window.hpp"

#include <cmath>

namespace underway {
namespace {

constexpr float kLeastGain = 0.05F;  // of a hit on a cell's mean

}  // namespace

Window::Window()
    : hits_(kCells * kCells),
      is_known_(kCells * kCells),
      is_seen_(kCells * kCells),
      means_(kCells * kCells) {}

void Window::clear() {
  std::fill(hits_.begin(), hits_.end(), std::uint8_t{0});
  std::fill(is_known_.begin(), is_known_.end(), std::uint8_t{0});
  std::fill(is_seen_.begin(), is_seen_.end(), std::uint8_t{0});
}

void Window::forget(std::size_t index) {
  hits_[index] = 0;
  is_known_[index] = 0;
  is_seen_[index] = 0;
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
  const auto forget_column = [this](std::int64_t x) {
    for (std::size_t row = 0; row < kCells; ++row) forget(row * kCells + wrapped(x));
  };
  const auto forget_row = [this](std::int64_t y) {
    for (std::size_t column = 0; column < kCells; ++column) forget(wrapped(y) * kCells + column);
  };
  while (corner_.x < corner.x) forget_column(corner_.x++);
  while (corner_.x > corner.x) forget_column(--corner_.x);
  while (corner_.y < corner.y) forget_row(corner_.y++);
  while (corner_.y > corner.y) forget_row(--corner_.y);
}

void Window::hit(Point at) {
  const Place place = placeOf(at);
  if (!isInside(place)) return;
  std::uint8_t& hits = hits_[indexOf(place)];
  Mean& mean = means_[indexOf(place)];
  if (hits < kMost) ++hits;
  const Point corner{static_cast<double>(place.x) * kCell_m, static_cast<double>(place.y) * kCell_m};
  const float gain = hits < kMost ? 1.0F / static_cast<float>(hits) : kLeastGain;
  mean.x_m += gain * (static_cast<float>(at.x - corner.x) - mean.x_m);
  mean.y_m += gain * (static_cast<float>(at.y - corner.y) - mean.y_m);
}

bool Window::isOccupied(Point at) const {
  const Place place = placeOf(at);
  return isInside(place) && hits_[indexOf(place)] >= kSure;
}

void Window::markKnown() {
  for (std::size_t i = 0; i < hits_.size(); ++i) is_known_[i] = hits_[i] >= kSure ? 1 : 0;
}

double Window::toEdge(Point from) const {
  constexpr double kHalf_m = 0.5 * static_cast<double>(kCells) * kCell_m;
  const double off_x = from.x - (static_cast<double>(corner_.x) * kCell_m + kHalf_m);
  const double off_y = from.y - (static_cast<double>(corner_.y) * kCell_m + kHalf_m);
  return kHalf_m - std::max(std::abs(off_x), std::abs(off_y));
}

void Window::pass(Point from, Point to) {
  constexpr double kShort_m = kCell_m;  // of the end: what stands there may reach nearer
  const double range = distance(from, to);
  const double seen = std::min(range, toEdge(from));
  if (!(seen > 0.0)) return;
  // Steps of a cell, in whole numbers of 2^-32 cells: no rounding down at each.
  constexpr int kFraction = 32;
  constexpr double kUnits = 4294967296.0 / kCell_m;
  const double share = kCell_m / range;
  const auto step_x = static_cast<std::int64_t>(kUnits * share * (to.x - from.x));
  const auto step_y = static_cast<std::int64_t>(kUnits * share * (to.y - from.y));
  auto x = static_cast<std::int64_t>(kUnits * from.x);
  auto y = static_cast<std::int64_t>(kUnits * from.y);
  const auto steps = static_cast<int>(seen / kCell_m);
  const auto free_steps = seen < kShort_m ? -1 : static_cast<int>((seen - kShort_m) / kCell_m);
  for (int k = 0; k <= steps; ++k, x += step_x, y += step_y) {
    const Place place{x >> kFraction, y >> kFraction};
    const std::size_t i = indexOf(place);
    is_seen_[i] = 1;
    if (k <= free_steps && hits_[i] > 0) --hits_[i];
  }
}

void Window::markSeen(Point at) {
  if (const Place place = placeOf(at); isInside(place)) is_seen_[indexOf(place)] = 1;
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
