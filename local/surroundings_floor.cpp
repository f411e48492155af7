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
  constexpr double kStep_m = 0.5 * Window::kCell_m;
  const double reach = is_placed_ ? 0.0 : reachOf(body) + Window::kCell_m;
  is_placed_ = true;
  for (double x = std::min(body.x.min, -reach); x <= std::max(body.x.max, reach); x += kStep_m)
    for (double y = std::min(body.y.min, -reach); y <= std::max(body.y.max, reach); y += kStep_m) {
      const bool is_on = x >= body.x.min && x <= body.x.max && y >= body.y.min && y <= body.y.max;
      if (is_on || std::hypot(x, y) <= reach) window_.markSeen(transform(at, {x, y}));
    }
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
