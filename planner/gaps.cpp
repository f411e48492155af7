#include "planner/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace underway {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kSmallestCell_m = 0.5;
constexpr double kTouching_m = 1e-6;

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
    add({box.center_m.x, box.center_m.y, box.rpy_rad.z}, 0.5 * box.size_m.x, 0.5 * box.size_m.y);
  }
  obstacle_count_ = footprints_.size();
  addBounds(world.bounds());
}

/// Into every cell whose middle is near enough: a point of the cell may look at it.
void Gaps::add(const Pose& frame, double half_x, double half_y) {
  footprints_.push_back({frame, half_x, half_y, std::cos(frame.yaw), std::sin(frame.yaw)});
  const double turned = frame.yaw - corner_.yaw;
  const double c = std::abs(std::cos(turned));
  const double s = std::abs(std::sin(turned));
  const Point local = pointIn(corner_, frame.x, frame.y);
  const auto range = [&](double middle, double half, std::size_t count) {
    const auto clamped = [&](double cell) {
      return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
    };
    const double reach = half + 2.0 * widest_m_;
    return std::pair(clamped(std::floor((middle - reach) / widest_m_)),
                     clamped(std::floor((middle + reach) / widest_m_)));
  };
  const auto [left, right] = range(local.x, c * half_x + s * half_y, columns_);
  const auto [low, high] = range(local.y, s * half_x + c * half_y, rows_);
  for (std::size_t row = low; row <= high; ++row)
    for (std::size_t column = left; column <= right; ++column)
      cells_[row * columns_ + column].push_back(static_cast<std::uint32_t>(footprints_.size() - 1));
}

/// As walls beyond their four sides.
void Gaps::addBounds(const Bounds& bounds) {
  constexpr double kHalf_m = 0.05;
  const double half_x = 0.5 * bounds.width_m;
  const double half_y = 0.5 * bounds.height_m;
  const auto add_wall = [&](double x, double y, double wall_half_x, double wall_half_y) {
    const Point at = transform(bounds.corner, {x, y});
    add({at.x, at.y, bounds.corner.yaw}, wall_half_x, wall_half_y);
  };
  add_wall(half_x, -kHalf_m, half_x, kHalf_m);
  add_wall(half_x, bounds.height_m + kHalf_m, half_x, kHalf_m);
  add_wall(-kHalf_m, half_y, kHalf_m, half_y);
  add_wall(bounds.width_m + kHalf_m, half_y, kHalf_m, half_y);
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

Point Gaps::nearestOn(const Footprint& footprint, Point to) {
  const Point local = pointIn(footprint.frame, to.x, to.y);
  return transform(footprint.frame, {std::clamp(local.x, -footprint.half_x, footprint.half_x),
                                     std::clamp(local.y, -footprint.half_y, footprint.half_y)});
}

std::optional<Gaps::Gap> Gaps::draw(std::mt19937_64& random) const {
  if (obstacle_count_ == 0) return std::nullopt;
  const std::size_t own = random() % obstacle_count_;
  const Look look = lookFrom(footprints_[own], random);
  if (!isOver(look.from)) return std::nullopt;
  const std::vector<std::uint32_t>& near = cells_[cellAt(look.from)];
  return random() % 3 == 0 ? betweenNearest(own, near[random() % near.size()]) : opposite(own, look, near);
}

Gaps::Look Gaps::lookFrom(const Footprint& footprint, std::mt19937_64& random) {
  const std::uint64_t face = random() % 4;
  const double along = 2.0 * uniform(random) - 1.0;
  const bool on_x = face % 2 == 0;
  const double sign = face < 2 ? 1.0 : -1.0;
  const Point local = on_x ? Point{sign * footprint.half_x, along * footprint.half_y}
                           : Point{along * footprint.half_x, sign * footprint.half_y};
  const double normal =
      footprint.frame.yaw + (on_x ? 0.0 : 0.5 * std::numbers::pi) + (sign > 0.0 ? 0.0 : std::numbers::pi);
  return {transform(footprint.frame, local), normal};
}

std::optional<Gaps::Gap> Gaps::opposite(std::size_t own, const Look& look,
                                        const std::vector<std::uint32_t>& near) const {
  const Point direction{std::cos(look.normal_rad), std::sin(look.normal_rad)};
  double nearest = kNone;
  for (const std::uint32_t other : near)
    if (other != own) nearest = std::min(nearest, wayTo(footprints_[other], look.from, direction));
  if (nearest > widest_m_ || nearest < kTouching_m) return std::nullopt;
  const Point middle{look.from.x + 0.5 * nearest * direction.x, look.from.y + 0.5 * nearest * direction.y};
  return Gap{middle, normalizedAngle(look.normal_rad), nearest};
}

/// Of two footprints that are apart: a corner of one is the point nearest to the other.
std::optional<Gaps::Gap> Gaps::betweenNearest(std::size_t own, std::size_t other) const {
  if (other == own) return std::nullopt;
  double least_m = kNone;
  Point from;
  Point to;
  for (const auto& [a, b] : {std::pair(own, other), std::pair(other, own)})
    for (const double x : {-footprints_[a].half_x, footprints_[a].half_x})
      for (const double y : {-footprints_[a].half_y, footprints_[a].half_y}) {
        const Point corner = transform(footprints_[a].frame, {x, y});
        const Point nearest = nearestOn(footprints_[b], corner);
        if (const double away_m = distance(corner, nearest); away_m < least_m)
          least_m = away_m, from = corner, to = nearest;
      }
  if (least_m > widest_m_ || least_m < kTouching_m) return std::nullopt;
  return Gap{
      {0.5 * (from.x + to.x), 0.5 * (from.y + to.y)}, std::atan2(to.y - from.y, to.x - from.x), least_m};
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
