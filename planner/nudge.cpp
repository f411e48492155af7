#include "planner/nudge.hpp"

#include <algorithm>
#include <cmath>

#include "planner/leg_sweeps.hpp"

namespace underway {
namespace {

constexpr int kMostSweeps = 5;
constexpr int kMostRepeats = 8;   // of a move that helped
constexpr std::size_t kNear = 1;  // steps away that a change is felt most
constexpr double kSamePoint_m = 1e-7;
constexpr double kCoarse_m = 0.05;  // smaller steps move stops and crossings alone, but next to dear legs
constexpr double kMostCut = 0.7;    // of a leg, when the corner at its end is cut

Point towards(Point from, Point to) {
  const double way_m = distance(from, to);
  return way_m > kSamePoint_m ? Point{(to.x - from.x) / way_m, (to.y - from.y) / way_m} : Point{1.0, 0.0};
}

Point between(Point from, Point to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

Option movedBy(const Option& stop, Point direction, double step_m) {
  Option moved = stop;
  moved.in.x += step_m * direction.x;
  moved.in.y += step_m * direction.y;
  moved.out = moved.in;
  return moved;
}

/// Whether a crossing moves as a whole and keeps its heading.
bool isShift(Movable::Move move) { return move <= Movable::Move::kRight; }

}  // namespace

Nudge::Nudge(const Movable::Rules& crossings, Passage passage)
    : robot_(crossings.checker->robot()),
      rules_(crossings),
      passage_(std::move(passage)),
      steps_(passage_.steps()),
      fresh_(steps_.size(), 0) {}

void Nudge::by(double step_m, Interrupt& interrupt) {
  std::fill(fresh_.begin(), fresh_.end(), 1);
  bool is_better = true;
  for (int sweep = 0; is_better && sweep < kMostSweeps; ++sweep) {
    is_better = false;
    for (Index i = 1; i < steps_.size(); ++i) {
      if (!fresh_[i]) continue;
      if (interrupt.isDueNow()) return;
      fresh_[i] = 0;
      if (!improveAt(i, step_m)) continue;
      markNear(i);
      is_better = true;
    }
  }
}

void Nudge::markNear(Index i) {
  const Index last = std::min(i + kNear, steps_.size() - 1);
  for (Index k = i > kNear ? i - kNear : 1; k <= last; ++k) fresh_[k] = 1;
}

bool Nudge::replace(Index first, Index count, std::span<const NewStep> news, Exchange::WayIndex way_after,
                    const Movable* crossing) {
  return passage_.replace(first, count, news, way_after, crossing) && refresh(first, count, news.size());
}

bool Nudge::rejoin(Index first, Index count, const Option& stop) {
  return passage_.rejoin(first, count, stop) && refresh(first, count, 1);
}

/// New steps are in the place of others.
bool Nudge::refresh(Index first, Index gone, Index come) {
  const auto at = fresh_.begin() + static_cast<std::ptrdiff_t>(first);
  fresh_.insert(fresh_.erase(at, at + static_cast<std::ptrdiff_t>(gone)), come, 1);
  return true;
}

// --- changes ----------------------------------------------------------------------------------------------

/// All changes that concern a step and the leg to it.
bool Nudge::improveAt(Index i, double step_m) {
  const bool is_thorough = step_m >= kCoarse_m || isNextToAside(i);
  const bool is_last = i + 1 == steps_.size();
  bool is_better = is_thorough && steps_[i].way && (changeWay(i) || putStopInto(i));
  if (is_last) return is_better;
  if (!steps_[i].option.is_stop) return moveCrossing(i, step_m) || is_better;
  if (!steps_[i].way || !steps_[i + 1].way) return is_better;
  if (is_thorough && leaveOut(i)) return true;
  is_better |= moveStop(i, step_m);
  if (!is_thorough) return is_better;
  is_better |= cutCorner(i, step_m);
  return (steps_[i + 1].option.is_stop && moveLeg(i, step_m)) || is_better;
}

bool Nudge::isNextToAside(Index i) const {
  return isAside(rules_.policy, steps_[i]) ||
         (i + 1 < steps_.size() && isAside(rules_.policy, steps_[i + 1]));
}

/// Along the legs that lead to a stretch of stops and on from it, and along and across it, or the line that
/// cuts a lone stop's corner. A move along a leg leaves its heading as it is.
Nudge::Directions Nudge::directionsAt(Index first, Index last) const {
  const Point before = steps_[first - 1].option.out.position();
  const Point from = steps_[first].option.in.position();
  const Point to = steps_[last].option.in.position();
  const Point after = steps_[last + 1].option.in.position();
  const Point along = first == last ? towards(before, after) : towards(from, to);
  Directions all;
  std::size_t i = 0;
  for (const Point axis : {towards(before, from), towards(to, after), along, Point{-along.y, along.x}}) {
    all[i++] = axis;
    all[i++] = {-axis.x, -axis.y};
  }
  return all;
}

bool Nudge::moveStop(Index i, double step_m) {
  const auto move = [&](const Option& to) {
    if (step_m >= kCoarse_m) return rejoin(i, 1, to);
    return replace(i, 1, std::array{NewStep{&to, steps_[i].legs, steps_[i].way}}, steps_[i + 1].way);
  };
  bool is_moved = rejoin(i, 1, Option(steps_[i].option));
  for (const Point direction : directionsAt(i, i))
    for (int k = 0; k < kMostRepeats && move(movedBy(steps_[i].option, direction, step_m)); ++k)
      is_moved = true;
  return is_moved;
}

bool Nudge::moveLeg(Index i, double step_m) {
  bool is_moved = false;
  for (const Point direction : directionsAt(i, i + 1)) {
    const Option first = movedBy(steps_[i].option, direction, step_m);
    const Option second = movedBy(steps_[i + 1].option, direction, step_m);
    is_moved |= replace(i, 2,
                        std::array{NewStep{&first, steps_[i].legs, steps_[i].way},
                                   NewStep{&second, steps_[i + 1].legs, steps_[i + 1].way}},
                        steps_[i + 2].way);
  }
  return is_moved;
}

bool Nudge::moveCrossing(Index i, double step_m) {
  Movable here(rules_.at(steps_, i), steps_[i].option.motions);
  bool is_moved = false;
  for (const Movable::Move move : Movable::kMoves)
    for (int k = 0; k < kMostRepeats; ++k) {
      auto moved = here.moved(move, step_m);
      if (!moved || !(putCrossing(i, *moved) || (isShift(move) && putCrossingAndStop(i, *moved)))) break;
      here = *std::move(moved);
      is_moved = true;
    }
  return is_moved;
}

bool Nudge::putCrossing(Index i, const Movable& moved) {
  const Option option = moved.option();
  const NewStep crossing{&option, steps_[i].legs, steps_[i].way};
  return replace(i, 1, std::array{crossing}, steps_[i + 1].way, &moved);
}

/// With the stop before it, or that after it: the leg between them keeps its heading.
bool Nudge::putCrossingAndStop(Index i, const Movable& moved) {
  const Option option = moved.option();
  const NewStep crossing{&option, steps_[i].legs, steps_[i].way};
  const auto along = [&](Index stop, const Pose& from, const Pose& to) {
    return movedBy(steps_[stop].option, {to.x - from.x, to.y - from.y}, 1.0);
  };
  const Option& old = steps_[i].option;
  if (isStopOnLegs(i - 1)) {
    const Option before = along(i - 1, old.in, option.in);
    const NewStep stop{&before, steps_[i - 1].legs, steps_[i - 1].way};
    if (replace(i - 1, 2, std::array{stop, crossing}, steps_[i + 1].way, &moved)) return true;
  }
  if (!isStopOnLegs(i + 1)) return false;
  const Option after = along(i + 1, old.out, option.out);
  const NewStep stop{&after, steps_[i + 1].legs, steps_[i + 1].way};
  return replace(i, 2, std::array{crossing, stop}, steps_[i + 2].way, &moved);
}

bool Nudge::isStopOnLegs(Index i) const {
  return i > 0 && i + 1 < steps_.size() && steps_[i].option.is_stop && steps_[i].way && steps_[i + 1].way;
}

bool Nudge::leaveOut(Index i) {
  LegSweeps sweeps(*steps_[i].legs, steps_[i - 1].option, steps_[i + 1].option);
  for (Index way = 0; way < steps_[i].legs->ways().size(); ++way)
    if (sweeps.isFree(way) && replace(i, 1, {}, way)) return true;
  return false;
}

/// Where a stop is at either end, its own changes (`rejoin`) do this.
bool Nudge::changeWay(Index i) {
  if (steps_[i].option.is_stop || steps_[i - 1].option.is_stop) return false;
  bool is_better = false;
  for (Index way = 0; way < steps_[i].legs->ways().size(); ++way)
    is_better |= way != *steps_[i].way && replace(i, 0, {}, way);
  return is_better;
}

/// Between stops, moving them does as well.
bool Nudge::putStopInto(Index i) {
  if (steps_[i].option.is_stop && steps_[i - 1].option.is_stop && !isNextToAside(i)) return false;
  const std::vector<Point> points = stopsBetween(steps_, i);
  return std::any_of(points.begin(), points.end(),
                     [&](Point at) { return rejoin(i, 0, Option::stop(at, robot_.margin_m)); });
}

/// Puts two stops in the place of one, before it and after it.
bool Nudge::cutCorner(Index i, double step_m) {
  const Point before = steps_[i - 1].option.out.position();
  const Point at = steps_[i].option.in.position();
  const Point after = steps_[i + 1].option.in.position();
  const double shorter_m = std::min(distance(before, at), distance(at, after));
  for (const double cut_m : {2.0 * step_m, step_m}) {
    if (cut_m > kMostCut * shorter_m) continue;
    const auto stop_towards = [&](Point to) {
      return Option::stop(between(at, to, cut_m / distance(at, to)), robot_.margin_m);
    };
    const Option first = stop_towards(before);
    const Option second = stop_towards(after);
    const Legs* legs = steps_[i].legs;
    for (Index way = 0; way < legs->ways().size(); ++way)
      if (replace(i, 1, std::array{NewStep{&first, legs, steps_[i].way}, NewStep{&second, legs, way}},
                  steps_[i + 1].way))
        return true;
  }
  return false;
}

}  // namespace underway
