// The floor that was seen: a body goes nowhere else. A lidar that looks ahead and to both sides is blind
// behind, and behind what it sees.

#include <algorithm>
#include <cmath>

#include "geometry/sweep.hpp"
#include "local/lane.hpp"
#include "local/seen_from.hpp"
#include "local/surroundings.hpp"

namespace underway {

/// Where it stands or lies nothing else does. Where it stood first, it may turn: nobody could look there.
void Surroundings::standOn(const BodyBox& body, const Pose& at) {
  constexpr double kCovered_m = 0.5 * Window::kCell_m;  // of a cell's half, that a body stands on
  const double all_round_m = is_placed_ ? 0.0 : reachOf(body) + Window::kCell_m;
  is_placed_ = true;
  const Range x = body.x.grown(kCovered_m);
  const Range y = body.y.grown(kCovered_m);
  const SeenFrom seen(at);
  window_.visitUnseen(at.position(), reachOf(body) + Window::kCell_m, [&](Point cell) {
    const Point local = seen(cell);
    const bool is_on = local.x >= x.min && local.x <= x.max && local.y >= y.min && local.y <= y.max;
    if (is_on || std::hypot(local.x, local.y) <= all_round_m) window_.markSeen(cell);
  });
}

/// What the map has needs no look: plans keep off it.
void Surroundings::addUnseenFloor(const Pose& from) {
  if (!robot_->senses.waist) return;
  constexpr double kReach_m = 0.35;  // of the body's corners and what a second leads to
  const SeenFrom seen(from);
  window_.visitUnseen(from.position(), kReach_m, [&](Point cell) {
    if (!waist_map_.isExpected(cell, 0.0)) against_unseen_.add(seen(cell));
  });
}

bool Surroundings::isAnyUnseen(const BodyBox& box, const Pose& at) const {
  const SeenFrom seen(at);
  bool is_any = false;
  window_.visitUnseen(at.position(), reachOf(box), [&](Point cell) {
    const Point local = seen(cell);
    is_any |= local.x > box.x.min && local.x < box.x.max && local.y > box.y.min && local.y < box.y.max &&
              !waist_map_.isExpected(cell, 0.0);
  });
  return is_any;
}

bool Surroundings::isFloorSeen(const Motion& translation, double along_m) const {
  if (!robot_->senses.waist) return true;
  constexpr double kStretch_m = 0.3;
  const BodyBox& body = robot_->modes[translation.mode].body_m;
  const double left_m = length(translation) - along_m;
  const Point here = pointAlong(translation, std::max(along_m, 0.0));
  const double stretch = std::clamp(left_m, 0.0, kStretch_m);
  BodyBox lane = body;
  lane.x.min -= stretch;
  if (isAnyUnseen(lane, {here.x, here.y, translation.from.yaw})) return false;
  if (left_m > kStretch_m) return true;
  const double reach = reachOf(body);
  return !isAnyUnseen({{-reach, reach}, {-reach, reach}, body.z}, translation.to);
}

}  // namespace underway
