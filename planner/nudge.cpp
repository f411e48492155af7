#include "planner/nudge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway {
namespace {

constexpr std::size_t kDirections = 8;
constexpr int kMostSweeps = 12;
constexpr int kMostRepeats = 8;   // of a move that helped
constexpr std::size_t kNear = 2;  // steps away that a change is felt
constexpr double kSamePoint_m = 1e-7;
constexpr double kCoarse_m = 0.05;  // smaller steps put no stops into legs

const std::array<Point, kDirections>& directions() {
  static const auto kAll = [] {
    std::array<Point, kDirections> all{};
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kDirections;
      all[i] = {std::cos(angle), std::sin(angle)};
    }
    return all;
  }();
  return kAll;
}

Option movedBy(const Option& stop, Point direction, double step_m) {
  Option moved = stop;
  moved.in.x += step_m * direction.x;
  moved.in.y += step_m * direction.y;
  moved.out = moved.in;
  return moved;
}

}  // namespace

Nudge::Nudge(const Movable::Rules& crossings, Passage passage)
    : robot_(crossings.checker->robot()),
      rules_(crossings),
      steps_(std::move(passage.steps)),
      links_(steps_.size()),
      fresh_(steps_.size(), 0) {
  for (Index i = 1; i < steps_.size(); ++i) {
    Node node = nodeOf(i);
    links_[i] = link(nodeOf(i - 1), node, Rigour::kFree);
  }
}

Passage Nudge::passage() && {
  Cost cost = steps_.front().option.cost;
  for (const Cost link : links_) cost = cost + link;
  return {std::move(steps_), cost};
}

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

Nudge::Node Nudge::nodeOf(Index i) const {
  const Passage::Step& step = steps_[i];
  return {&step.option, step.legs, step.way, step.arriving, step.leaving};
}

// --- changes ----------------------------------------------------------------------------------------------

/// All changes that concern a step and the leg to it.
bool Nudge::improveAt(Index i, double step_m) {
  bool is_better = false;
  if (steps_[i].way) {
    is_better |= changeWay(i);
    if (step_m >= kCoarse_m) is_better |= putStopInto(i, step_m);
  }
  if (i + 1 == steps_.size()) return is_better;
  if (!steps_[i].option.is_stop) return moveCrossing(i, step_m) || is_better;
  if (!steps_[i].way || !steps_[i + 1].way) return is_better;
  if (leaveOut(i)) return true;
  is_better |= changeWaysRound(i);
  is_better |= moveStop(i, step_m);
  return (steps_[i + 1].option.is_stop && moveLeg(i, step_m)) || is_better;
}

bool Nudge::moveStop(Index i, double step_m) {
  bool is_moved = false;
  for (const Point direction : directions()) {
    for (int k = 0; k < kMostRepeats; ++k) {
      const Option moved = movedBy(steps_[i].option, direction, step_m);
      if (!replace(i, 1, std::array{Node{&moved, steps_[i].legs, steps_[i].way, {}, {}}}, steps_[i + 1].way))
        break;
      is_moved = true;
    }
  }
  return is_moved;
}

bool Nudge::moveLeg(Index i, double step_m) {
  bool is_moved = false;
  for (const Point direction : directions()) {
    const Option first = movedBy(steps_[i].option, direction, step_m);
    const Option second = movedBy(steps_[i + 1].option, direction, step_m);
    is_moved |= replace(i, 2,
                        std::array{Node{&first, steps_[i].legs, steps_[i].way, {}, {}},
                                   Node{&second, steps_[i + 1].legs, steps_[i + 1].way, {}, {}}},
                        steps_[i + 2].way);
  }
  return is_moved;
}

bool Nudge::moveCrossing(Index i, double step_m) {
  const Movable::Rules rules = rules_.at(steps_, i);
  bool is_moved = false;
  for (const Movable::Move move : Movable::kMoves) {
    for (int k = 0; k < kMostRepeats; ++k) {
      const auto moved = Movable(rules, steps_[i].option.motions).moved(move, step_m);
      if (!moved) break;
      const Option option = moved->option();
      if (!replace(i, 1, std::array{Node{&option, steps_[i].legs, steps_[i].way, {}, {}}}, steps_[i + 1].way,
                   &*moved))
        break;
      is_moved = true;
    }
  }
  return is_moved;
}

bool Nudge::leaveOut(Index i) {
  for (Index way = 0; way < steps_[i].legs->ways().size(); ++way)
    if (replace(i, 1, {}, way)) return true;
  return false;
}

bool Nudge::changeWay(Index i) {
  bool is_better = false;
  for (Index way = 0; way < steps_[i].legs->ways().size(); ++way)
    is_better |= way != *steps_[i].way && replace(i, 0, {}, way);
  return is_better;
}

bool Nudge::changeWaysRound(Index i) {
  bool is_better = false;
  const Option here = steps_[i].option;
  const Legs* legs = steps_[i].legs;
  for (Index to = 0; to < legs->ways().size(); ++to)
    for (Index after = 0; after < legs->ways().size(); ++after)
      is_better |= to != *steps_[i].way && after != *steps_[i + 1].way &&
                   replace(i, 1, std::array{Node{&here, legs, to, {}, {}}}, after);
  return is_better;
}

bool Nudge::putStopInto(Index i, double step_m) {
  const std::vector<Point> points = stopsBetween(steps_, i, step_m);
  return std::any_of(points.begin(), points.end(), [&](Point at) { return putStop(i, at); });
}

bool Nudge::putStop(Index i, Point at) {
  const Option stop = Option::stop(at, robot_.margin_m);
  const Legs* legs = steps_[i].legs;
  for (Index to = 0; to < legs->ways().size(); ++to)
    for (Index after = 0; after < legs->ways().size(); ++after)
      if (replace(i, 0, std::array{Node{&stop, legs, to, {}, {}}}, after)) return true;
  return false;
}

// --- what they cost ---------------------------------------------------------------------------------------

bool Nudge::replace(Index first, Index count, std::span<const Node> news, WayIndex way_after,
                    const Movable* crossing) {
  const Index after = first + count;
  Trail trail;
  trail.add(nodeOf(first - 1));
  for (const Node& node : news) trail.add(node);
  trail.add(nodeOf(after));
  trail.nodes[trail.size - 1].way = way_after;
  if (after + 1 < steps_.size()) trail.add(nodeOf(after + 1));
  Cost bound;
  for (Index i = first; i <= std::min(after + 1, steps_.size() - 1); ++i) bound = bound + links_[i];
  if (!mayBeCheaper(trail, bound) || !isCheaper(trail, bound, Rigour::kCostsOnly) ||
      (crossing && !crossing->isFree()) || !isCheaper(trail, bound, Rigour::kFree))
    return false;
  put(first, count, news, trail);
  return true;
}

/// Whether the legs alone, without any turns, leave a chance.
bool Nudge::mayBeCheaper(const Trail& trail, Cost bound) {
  Cost sum;
  for (std::size_t k = 1; k < trail.size; ++k) {
    const Node& node = trail.nodes[k];
    sum = sum + node.option->cost;
    if (!node.way) continue;
    const double way_m = distance(trail.nodes[k - 1].option->out.position(), node.option->in.position());
    sum = sum + node.legs->legCost(node.legs->ways()[*node.way], way_m);
    if (sum >= bound) return false;
  }
  return true;
}

bool Nudge::isCheaper(Trail& trail, Cost bound, Rigour rigour) {
  Cost sum;
  for (std::size_t k = 1; k < trail.size; ++k) {
    trail.links[k] = link(trail.nodes[k - 1], trail.nodes[k], rigour);
    sum = sum + trail.links[k];
    if (sum >= bound) return false;
  }
  return true;
}

/// The cost of coming to a step from the one before, and the stances on the way.
Cost Nudge::link(const Node& before, Node& node, Rigour rigour) {
  const Legs& legs = *node.legs;
  const Option& a = *before.option;
  const Option& b = *node.option;
  const auto change = [&](Point at, const Stance& from, const Stance& to, double keep_m) {
    return rigour == Rigour::kFree ? legs.freeChangeCost(at, from, to, keep_m) : legs.changeCost(from, to);
  };
  Cost cost;
  node.arriving = before.leaving;
  if (node.way) {
    const Point from = a.out.position();
    const Point to = b.in.position();
    const Way& way = legs.ways()[*node.way];
    const double way_m = distance(from, to);
    if (way_m <= kSamePoint_m) return Cost::most();
    node.arriving = legs.stanceOn(std::atan2(to.y - from.y, to.x - from.x), *node.way);
    if (rigour == Rigour::kFree &&
        !legs.isLegFree(way, from, to, node.arriving.yaw, std::min(a.keep_m, b.keep_m)))
      return Cost::most();
    cost = legs.legCost(way, way_m) + change(from, before.leaving, node.arriving, a.keep_m);
  } else if (!(a.out.position() == b.in.position())) {
    return Cost::most();
  }
  node.leaving = node.arriving;
  if (b.is_stop) return cost;
  const Stance needed{b.any_heading ? node.arriving.yaw : b.in.yaw, b.in_mode};
  node.leaving = {b.any_heading ? node.arriving.yaw : b.out.yaw, b.out_mode};
  return cost + change(b.in.position(), node.arriving, needed, b.keep_m) + b.cost;
}

/// Makes a change that has been worked out.
void Nudge::put(Index first, Index count, std::span<const Node> news, const Trail& trail) {
  std::vector<Passage::Step> steps;
  for (const Node& node : news) steps.push_back({*node.option, node.legs, node.way, {}, {}});
  const auto at = [first](auto& list) { return list.begin() + static_cast<std::ptrdiff_t>(first); };
  const auto replaceIn = [&](auto& list, const auto& by) {
    const auto gone = at(list);
    list.insert(list.erase(gone, gone + static_cast<std::ptrdiff_t>(count)), by.begin(), by.end());
  };
  replaceIn(steps_, steps);
  replaceIn(links_, std::vector<Cost>(news.size()));
  replaceIn(fresh_, std::vector<char>(news.size(), 1));
  for (std::size_t k = 1; k < trail.size; ++k) {
    Passage::Step& step = steps_[first + k - 1];
    step.way = trail.nodes[k].way;
    step.arriving = trail.nodes[k].arriving;
    step.leaving = trail.nodes[k].leaving;
    links_[first + k - 1] = trail.links[k];
  }
}

}  // namespace underway
