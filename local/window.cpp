#include "local/window.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "local/seen_from.hpp"

namespace underway {
namespace {

constexpr float kLeastGain = 0.05F;  // of a hit on a cell's mean
constexpr float kFirst_m2 = 1e-4F;   // along each axis, before the spread is known: 1 cm

}  // namespace

Window::Window()
    : hits_(Grid::kCount), is_known_(Grid::kCount), means_(Grid::kCount), spreads_(Grid::kCount) {}

void Window::slideTo(Point at) {
  grid_.slideTo(at, [this](std::size_t i) { hits_[i] = is_known_[i] = 0; });
}

void Window::hit(Point at) {
  const Grid::Place place = Grid::placeOf(at);
  if (!grid_.isInside(place)) return;
  const std::size_t i = Grid::indexOf(place);
  std::uint8_t& hits = hits_[i];
  Mean& mean = means_[i];
  Spread& spread = spreads_[i];
  if (hits < kMost) ++hits;
  may_have_hits_[i / 64] |= std::uint64_t{1} << i % 64;
  const Point corner = Grid::cornerOf(place);
  if (hits == 1) {
    mean = {static_cast<float>(at.x - corner.x), static_cast<float>(at.y - corner.y)};
    spread = {kFirst_m2, 0.0F, kFirst_m2};
    return;
  }
  const float gain = hits < kMost ? 1.0F / static_cast<float>(hits) : kLeastGain;
  const float x = static_cast<float>(at.x - corner.x) - mean.x_m;
  const float y = static_cast<float>(at.y - corner.y) - mean.y_m;
  mean.x_m += gain * x;
  mean.y_m += gain * y;
  const float kept = 1.0F - gain;
  spread.xx_m2 = kept * (spread.xx_m2 + gain * x * x);
  spread.xy_m2 = kept * (spread.xy_m2 + gain * x * y);
  spread.yy_m2 = kept * (spread.yy_m2 + gain * y * y);
}

/// By the principal axes of a symmetric matrix of two rows; half an angle's sine and cosine without the
/// angle.
Window::Extents Window::extentsOf(const Spread& spread, Point view, double sigma_m) {
  constexpr double kEven = 3.0;  // half an even stretch, squared, over its variance
  const double noise = sigma_m * sigma_m;
  const double xx = spread.xx_m2 - noise * view.x * view.x;
  const double yy = spread.yy_m2 - noise * view.y * view.y;
  const double middle = 0.5 * (xx + yy);
  const double half = 0.5 * (xx - yy);
  const double cross = spread.xy_m2 - noise * view.x * view.y;
  const double off = std::sqrt(half * half + cross * cross);
  const double cos_twice = off > 0.0 ? half / off : 1.0;
  const Point along{std::sqrt(std::max(0.5 + 0.5 * cos_twice, 0.0)),
                    std::copysign(std::sqrt(std::max(0.5 - 0.5 * cos_twice, 0.0)), cross)};
  const double longer = std::sqrt(kEven * std::max(middle + off, 0.0));
  const double shorter = std::sqrt(kEven * std::max(middle - off, 0.0));
  return {longer, {longer * along.x, longer * along.y}, {-shorter * along.y, shorter * along.x}};
}

bool Window::isOccupied(Point at) const {
  const Grid::Place place = Grid::placeOf(at);
  return grid_.isInside(place) && hits_[Grid::indexOf(place)] >= kSure;
}

void Window::markKnown() {
  for (std::size_t i = 0; i < hits_.size(); ++i) is_known_[i] = hits_[i] >= kSure ? 1 : 0;
}

void Window::takeBack(const Scan& scan, const Pose& from, double far_m) {
  const SeenFrom seen(from);
  const auto is_passed = [&](std::size_t i) {
    const Point at = seen(meanOf(i, grid_.placeAt(i)));
    const double range_m = std::sqrt(at.x * at.x + at.y * at.y);
    return range_m < far_m && scan.leastNear(std::atan2(at.y, at.x)) > range_m + kShort_m;
  };
  for (std::size_t word = half_; word < may_have_hits_.size(); word += 2)
    for (std::uint64_t left = may_have_hits_[word]; left != 0; left &= left - 1) {
      const std::size_t i = 64 * word + static_cast<std::size_t>(std::countr_zero(left));
      if (hits_[i] > 0 && is_passed(i)) --hits_[i];
      if (hits_[i] == 0) may_have_hits_[word] &= ~(left & (~left + 1));
    }
  half_ = 1 - half_;
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
