#include "local/surroundings.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/sweep.hpp"
#include "local/lane.hpp"

namespace underway {
namespace {

constexpr std::size_t kMostPoints = 2048;
constexpr double kMargin_m = 0.005;  // from what is unmapped; the nearest of many noisy beams adds to it
constexpr double kGuarded_m = 1.0;   // what is further away cannot be run into in a tick

Tolerance toleranceOf(const SurroundingsSettings& settings) {
  Tolerance tolerance;
  tolerance.near_m = 0.025 + 2.0 * settings.sensor_sigma_m;
  return tolerance;
}

/// How many noisy beams may seem to end inside a body that keeps 2 cm from a wall.
std::size_t outliersOf(const SurroundingsSettings& settings) {
  const double of_margin = settings.sensor_sigma_m / 0.01;
  return static_cast<std::size_t>(std::lround(6.0 * of_margin * of_margin));
}

}  // namespace

Surroundings::Surroundings(const SurroundingsSettings& settings, std::shared_ptr<const Robot> robot)
    : settings_(settings),
      robot_(std::move(robot)),
      against_unmapped_({kMargin_m, 1.0, 0}, robot_->modes.front().body_m, kMostPoints),
      against_all_({0.0, 0.5, outliersOf(settings)}, robot_->modes.front().body_m, kMostPoints) {}

void Surroundings::expect(const World& map, const Plan& plan) {
  if (robot_->senses.waist) {
    const double height = robot_->senses.waist->height_m;
    waist_map_ = MapView(map, {height, height}, plan, toleranceOf(settings_), settings_.round_m);
  }
  if (robot_->senses.head) {
    const double height = robot_->senses.head->height_m;
    head_map_ = MapView(map, {height, height}, plan, toleranceOf(settings_), settings_.round_m);
  }
  if (robot_->senses.depth)
    depth_map_ = MapView(map, {0.02, robot_->modes.front().body_m.z.max}, plan, toleranceOf(settings_),
                         settings_.round_m);
  window_.markKnown();
}

void Surroundings::see(const Senses& senses, const Pose& from) {
  against_unmapped_.clear();
  against_all_.clear();
  window_.slideTo(from.position());
  ++turn_;
  const bool is_lying = robot_->modes[senses.mode].body_m.z.max < robot_->modes.front().body_m.z.max;
  if (senses.scan != nullptr) look(*senses.scan, is_lying ? head_map_ : waist_map_, from);
  if (senses.depth != nullptr) look(*senses.depth, depth_map_, from);
  if (senses.scan != nullptr) against_all_.look(*senses.scan);
  addWhatWasSeen(from);
}

/// What was seen before: no beam may look there now.
void Surroundings::addWhatWasSeen(const Pose& from) {
  constexpr double kReach_m = 0.5;
  const Pose back = before({0.0, 0.0, 0.0}, from);
  window_.visitOccupied(from.position(), kReach_m, [&](Point cell, bool) {
    against_unmapped_.add(transform({back.x, back.y, -from.yaw}, cell));
  });
}

void Surroundings::look(const Scan& scan, const MapView& map, const Pose& from) {
  // A plane that passes below a table top must not take back what a depth camera saw of it.
  const bool takes_back = !robot_->senses.depth || &map == &depth_map_;
  constexpr std::size_t kShare = 16;  // of the beams, looked at for what is free, each tick others
  const double c = std::cos(from.yaw);
  const double s = std::sin(from.yaw);
  forEachBeam(scan.beams, from.yaw, [&](std::size_t i, Point direction) {
    const double range = scan.ranges_m[i];
    const double reach = std::min(range, settings_.believed_m);
    const Point end{from.x + reach * direction.x, from.y + reach * direction.y};
    if (takes_back && i % kShare == turn_ % kShare) window_.pass(from.position(), end);
    if (range >= settings_.believed_m || map.isExpected(end, range)) return;
    window_.hit(end);
    const Point ahead{c * direction.x + s * direction.y, c * direction.y - s * direction.x};
    if (range < kGuarded_m) against_unmapped_.add({range * ahead.x, range * ahead.y});
  });
}

bool Surroundings::isLaneBlocked(const Motion& translation, double along_m, double shift_m) const {
  const BodyBox& body = robot_->modes[translation.mode].body_m;
  const bool along_x = translation.sense == Sense::kForward || translation.sense == Sense::kBackward;
  const Range across = (along_x ? body.y : body.x).grown(settings_.lane_margin_m);
  const Range along = along_x ? body.x : body.y;
  const double half = std::max(-across.min, across.max);
  const double reach = std::max(-along.min, along.max) + settings_.lane_margin_m;
  const double last = std::min(along_m + settings_.ahead_m, length(translation)) + reach;
  const Point middle = pointAlong(translation, 0.5 * (along_m + last));
  bool is_blocked = false;
  window_.visitOccupied(
      middle, 0.5 * (last - along_m) + 2.0 * half + std::abs(shift_m), [&](Point cell, bool is_known) {
        if (is_known) return;
        const OnLane at = onLane(translation, {cell.x, cell.y, 0.0});
        is_blocked |= std::abs(at.left_m - shift_m) < half && at.along_m > along_m && at.along_m < last;
      });
  return is_blocked;
}

bool Surroundings::isTurnBlocked(const Pose& at) const {
  const double reach = reachOf(robot_->modes.front().body_m);
  bool is_blocked = false;
  window_.visitOccupied(at.position(), reach + Window::kCell_m, [&](Point cell, bool is_known) {
    is_blocked |= !is_known && distance(cell, at.position()) < reach;
  });
  return is_blocked;
}

bool Surroundings::isBoxBlocked(const BodyBox& box, const Pose& at) const {
  const Pose back = before({0.0, 0.0, 0.0}, at);
  const Range x = box.x.grown(settings_.lane_margin_m);
  const Range y = box.y.grown(settings_.lane_margin_m);
  bool is_blocked = false;
  window_.visitOccupied(at.position(), reachOf(box) + Window::kCell_m, [&](Point cell, bool is_known) {
    if (is_known) return;
    const Point local = transform({back.x, back.y, -at.yaw}, cell);
    is_blocked |= local.x > x.min && local.x < x.max && local.y > y.min && local.y < y.max;
  });
  return is_blocked;
}

std::optional<double> Surroundings::shiftAround(const Motion& translation, double along_m,
                                                double most_m) const {
  constexpr double kStep_m = 0.05;
  if (!isLaneBlocked(translation, along_m)) return 0.0;
  for (double shift = kStep_m; shift <= most_m; shift += kStep_m)
    for (const double side : {shift, -shift})
      if (!isLaneBlocked(translation, along_m, side)) return side;
  return std::nullopt;
}

Velocity Surroundings::guarded(const Velocity& wanted) const {
  return against_all_.allowed(against_unmapped_.allowed(wanted));
}

std::vector<Point> Surroundings::surprisesNear(Point at, double reach_m) const {
  std::vector<Point> cells;
  window_.visitOccupied(at, reach_m, [&](Point cell, bool) { cells.push_back(cell); });
  return cells;
}

}  // namespace underway
