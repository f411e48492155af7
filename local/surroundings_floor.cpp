// The floor that was seen: a body goes nowhere else. A lidar that looks ahead and to both sides is blind
// behind, and behind what it sees.

#include <algorithm>
#include <cmath>

#include "geometry/sweep.hpp"
#include "local/lane.hpp"
#include "local/seen_from.hpp"
#include "local/surroundings.hpp"

namespace underway {

/// Where it stands or lies nothing else does; beside it something may, or a belief that trembles would lead
/// it on bit by bit. Where it stood first, it may turn: nobody could look there.
void Surroundings::standOn(const BodyBox& body, const Pose& at) {
  if (stood_ < kSettling) ++stood_, standFirstAt(reachOf(body), at.position());
  const SeenFrom seen(at);
  floor_.visitUnseen(extentOf(body, at), [&](Point cell) {
    const Point local = seen(cell);
    if (local.x >= body.x.min && local.x <= body.x.max && local.y >= body.y.min && local.y <= body.y.max)
      floor_.mark(cell);
  });
}

void Surroundings::standFirstAt(double reach_m, Point at) {
  constexpr double kRound_m = 0.05;   // that the guard lets it turn there
  constexpr double kCamera_m = 0.15;  // its field leaves slivers beside the way, close to the body
  const double round_m = reach_m + (robot_->senses.depth ? kCamera_m : kRound_m);
  floor_.visitUnseen(round(at, round_m), [&](Point cell) {
    if (distance(cell, at) <= round_m) floor_.mark(cell);
  });
}

/// What the map has needs no look: plans keep off it.
void Surroundings::addUnseenFloor(const Pose& from) {
  if (!robot_->senses.waist) return;
  const SeenFrom seen(from);
  floor_.visitUnseen(round(from.position(), reach_m_), [&](Point cell) {
    if (!waist_map_.isExpected(cell, 0.0)) against_unseen_.add(seen(cell));
  });
}

std::vector<Point> Surroundings::unseenNear(Point at, double reach_m) const {
  std::vector<Point> cells;
  if (!robot_->senses.waist) return cells;
  floor_.visitUnseen(round(at, reach_m), [&](Point cell) {
    if (!waist_map_.isExpected(cell, 0.0)) cells.push_back(cell);
  });
  return cells;
}

template <class Visit>
void Surroundings::visitUnseenIn(const BodyBox& box, const Pose& at, const Visit& visit) const {
  const SeenFrom seen(at);
  floor_.visitUnseen(extentOf(box, at), [&](Point cell) {
    const Point local = seen(cell);
    if (local.x > box.x.min && local.x < box.x.max && local.y > box.y.min && local.y < box.y.max &&
        !waist_map_.isExpected(cell, 0.0))
      visit(cell);
  });
}

std::optional<double> Surroundings::unseenBehind(const Motion& translation, double along_m,
                                                 const Pose& from) const {
  if (!robot_->senses.waist) return std::nullopt;
  constexpr double kStretch_m = 0.3;
  const SeenFrom seen(from);
  std::optional<double> bearing;
  const auto take = [&](Point cell) {
    const Point local = seen(cell);
    const double its = std::atan2(local.y, local.x);
    if (!bearing || std::abs(its) < std::abs(*bearing)) bearing = its;
  };
  const double left_m = length(translation) - along_m;
  const Point here = pointAlong(translation, std::max(along_m, 0.0));
  const BodyBox& body = robot_->modes[translation.mode].body_m;
  BodyBox lane = body;
  lane.x = body.x.grown(kUnseen_m);
  lane.y = body.y.grown(kUnseen_m);
  lane.x.min -= std::clamp(left_m, 0.0, kStretch_m);
  visitUnseenIn(lane, {here.x, here.y, translation.from.yaw}, take);
  if (bearing || left_m > kStretch_m) return bearing;
  const double reach = reachOf(body);
  visitUnseenIn({{-reach, reach}, {-reach, reach}, body.z}, translation.to, take);
  return bearing;
}

}  // namespace underway
