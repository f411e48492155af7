#include "planner/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace underway {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kSmallestCell_m = 0.5;

/// In [0, 1). std::uniform_real_distribution may differ between libraries.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

/// Where a ray from 0 along `ahead` enters and leaves [-half, half], on one axis.
Range crossing(double from, double ahead, double half) {
  if (ahead == 0.0) return std::abs(from) <= half ? Range{-kNone, kNone} : Range{kNone, -kNone};
  const double a = (-half - from) / ahead;
  const double b = (half - from) / ahead;
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Gaps::Gaps(const World& world, Range slab, double widest_m)
    : widest_m_(std::max(widest_m, kSmallestCell_m)), corner_(world.bounds().corner) {
  columns_ = static_cast<std::size_t>(world.bounds().width_m / widest_m_) + 1;
  rows_ = static_cast<std::size_t>(world.bounds().height_m / widest_m_) + 1;
  cells_.resize(columns_ * rows_);
  for (const Obstacle& obstacle : world.obstacles()) {
    const OrientedBox& box = obstacle.box;
    const double half_z = 0.5 * box.size_m.z;
    const bool is_seen = box.center_m.z - half_z <= slab.max && box.center_m.z + half_z >= slab.min;
    if (!is_seen || box.rpy_rad.x != 0.0 || box.rpy_rad.y != 0.0) continue;
    footprints_.push_back({{box.center_m.x, box.center_m.y, box.rpy_rad.z},
                           0.5 * box.size_m.x,
                           0.5 * box.size_m.y,
                           std::cos(box.rpy_rad.z),
                           std::sin(box.rpy_rad.z)});
    // Into every cell whose middle is near enough: a point of the cell may look at it.
    const double reach = std::hypot(footprints_.back().half_x, footprints_.back().half_y) + 2.0 * widest_m_;
    const auto range = [&](double middle, std::size_t count) {
      const auto clamped = [&](double cell) {
        return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
      };
      return std::pair(clamped(std::floor((middle - reach) / widest_m_)),
                       clamped(std::floor((middle + reach) / widest_m_)));
    };
    const Point local = pointIn(corner_, box.center_m.x, box.center_m.y);
    const auto [left, right] = range(local.x, columns_);
    const auto [low, high] = range(local.y, rows_);
    for (std::size_t row = low; row <= high; ++row)
      for (std::size_t column = left; column <= right; ++column)
        cells_[row * columns_ + column].push_back(static_cast<std::uint32_t>(footprints_.size() - 1));
  }
}

Point Gaps::pointIn(const Pose& frame, double x, double y) {
  const Point offset{x - frame.x, y - frame.y};
  return transform({0.0, 0.0, -frame.yaw}, offset);
}

double Gaps::wayTo(const Footprint& footprint, Point from, Point direction) {
  const double dx = from.x - footprint.frame.x;
  const double dy = from.y - footprint.frame.y;
  const double c = footprint.cos;
  const double s = footprint.sin;
  const Range x = crossing(c * dx + s * dy, c * direction.x + s * direction.y, footprint.half_x);
  if (x.max <= 0.0) return kNone;
  const Range y = crossing(c * dy - s * dx, c * direction.y - s * direction.x, footprint.half_y);
  const double enters = std::max(x.min, y.min);
  return enters <= std::min(x.max, y.max) && enters > 0.0 ? enters : kNone;
}

std::optional<Gaps::Gap> Gaps::draw(std::mt19937_64& random) const {
  if (footprints_.empty()) return std::nullopt;
  const std::size_t own = random() % footprints_.size();
  const Footprint& footprint = footprints_[own];
  const std::uint64_t face = random() % 4;
  const double along = 2.0 * uniform(random) - 1.0;
  const bool on_x = face % 2 == 0;
  const double sign = face < 2 ? 1.0 : -1.0;
  const Point local = on_x ? Point{sign * footprint.half_x, along * footprint.half_y}
                           : Point{along * footprint.half_x, sign * footprint.half_y};
  const Point from = transform(footprint.frame, local);
  const double normal =
      footprint.frame.yaw + (on_x ? 0.0 : 0.5 * std::numbers::pi) + (sign > 0.0 ? 0.0 : std::numbers::pi);
  if (!isOver(from)) return std::nullopt;
  const Point direction{std::cos(normal), std::sin(normal)};
  double nearest = kNone;
  for (const std::uint32_t other : cells_[cellAt(from)])
    if (other != own) nearest = std::min(nearest, wayTo(footprints_[other], from, direction));
  if (nearest > widest_m_) return std::nullopt;
  const Point middle{from.x + 0.5 * nearest * direction.x, from.y + 0.5 * nearest * direction.y};
  return Gap{middle, normalizedAngle(normal), nearest};
}

bool Gaps::isOver(Point point) const {
  const Point local = pointIn(corner_, point.x, point.y);
  return local.x >= 0.0 && local.y >= 0.0 && local.x < widest_m_ * static_cast<double>(columns_) &&
         local.y < widest_m_ * static_cast<double>(rows_);
}

std::size_t Gaps::cellAt(Point point) const {
  const Point local = pointIn(corner_, point.x, point.y);
  return static_cast<std::size_t>(local.y / widest_m_) * columns_ +
         static_cast<std::size_t>(local.x / widest_m_);
}

}  // namespace underway
