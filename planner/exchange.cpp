#include "planner/exchange.hpp"

#include <algorithm>
#include <cmath>

#include "planner/leg_sweeps.hpp"

namespace underway {
namespace {

constexpr double kSamePoint_m = 1e-7;
// The least clearance of new turns: to this, certificates judge them (judge.hpp).
constexpr double kTurns_m = 1e-4;

}  // namespace

Exchange::Exchange(Passage passage) : steps_(std::move(passage.steps)), links_(steps_.size()) {
  for (Index i = 1; i < steps_.size(); ++i) {
    Node node = nodeOf(i);
    arrive(nodeOf(i - 1), node);
    link(nodeOf(i - 1), node);
    steps_[i].arriving = node.arriving;
    steps_[i].leaving = node.leaving;
    links_[i] = freeLink(nodeOf(i - 1), node, 0.0);
  }
}

Passage Exchange::passage() && {
  Cost cost = steps_.front().option.cost;
  for (const Cost link : links_) cost = cost + link;
  return {std::move(steps_), cost};
}

Exchange::Node Exchange::nodeOf(Index i) const {
  const Passage::Step& step = steps_[i];
  return {&step.option, step.legs, step.way, step.arriving, step.leaving};
}

Cost Exchange::costOf(Index first, Index last) const {
  Cost sum;
  for (Index i = first; i <= std::min(last, steps_.size() - 1); ++i) sum = sum + links_[i];
  return sum;
}

bool Exchange::rejoin(Index first, Index count, const Option& stop) {
  const Legs& legs = *steps_[first].legs;
  LegSweeps to_it(legs, steps_[first - 1].option, stop);
  LegSweeps from_it(legs, stop, steps_[first + count].option);
  std::vector<WayPair> pairs = cheaperPairs(first, count, stop);
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const WayPair& a, const WayPair& b) { return a.cost < b.cost; });
  return std::any_of(pairs.begin(), pairs.end(), [&](const WayPair& pair) {
    return to_it.isFree(pair.to) && from_it.isFree(pair.on) &&
           replace(first, count, std::array{NewStep{&stop, &legs, pair.to}}, pair.on);
  });
}

/// By which ways a stop could be come to and left for less than what is there now.
std::vector<Exchange::WayPair> Exchange::cheaperPairs(Index first, Index count, const Option& stop) const {
  const Legs& legs = *steps_[first].legs;
  const Passage::Step& before = steps_[first - 1];
  const Point from = before.option.out.position();
  const Point at = stop.in.position();
  const double way_m = distance(from, at);
  if (way_m <= kSamePoint_m || distance(at, steps_[first + count].option.in.position()) <= kSamePoint_m)
    return {};
  const double direction = std::atan2(at.y - from.y, at.x - from.x);
  const Onwards onwards = onwardsFrom(stop, first + count);
  const Cost bound = costOf(first, first + count + 1);
  std::vector<WayPair> pairs;
  for (Index to = 0; to < legs.ways().size(); ++to) {
    const Stance stance = legs.stanceOn(direction, to);
    const Cost here = legs.legCost(legs.ways()[to], way_m) + legs.changeCost(before.leaving, stance);
    for (Index on = 0; on < legs.ways().size() && here < bound; ++on) {
      const Cost there = here + onwards[on].cost;
      if (there >= bound) continue;
      const Cost cost = there + legs.changeCost(stance, onwards[on].stance);
      if (cost < bound) pairs.push_back({to, on, cost});
    }
  }
  return pairs;
}

/// By each way from a stop to a step: what is touched by it, but for the change of stance at the stop itself.
Exchange::Onwards Exchange::onwardsFrom(const Option& stop, Index to_step) const {
  const Legs& legs = *steps_[to_step].legs;
  const Option& next = steps_[to_step].option;
  const Point from = stop.in.position();
  const Point to = next.in.position();
  const Passage::Step* turning = next.is_stop && steps_[to_step + 1].way ? &steps_[to_step + 1] : nullptr;
  Cost rest = next.cost;
  if (turning)
    rest = legs.legCost(legs.ways()[*turning->way], distance(to, turning->option.in.position()));
  else if (!next.is_stop && !next.any_heading && to_step + 1 < steps_.size())
    rest = rest + links_[to_step + 1];
  const double way_m = distance(from, to);
  const double direction = std::atan2(to.y - from.y, to.x - from.x);
  Onwards all;
  for (Index way = 0; way < legs.ways().size(); ++way) {
    const Stance stance = legs.stanceOn(direction, way);
    Stance needed = stance;
    if (turning)
      needed = turning->arriving;
    else if (!next.is_stop)
      needed = {next.any_heading ? stance.yaw : next.in.yaw, next.in_mode};
    all[way] = {stance, rest + legs.legCost(legs.ways()[way], way_m) + legs.changeCost(stance, needed)};
  }
  return all;
}

bool Exchange::replace(Index first, Index count, std::span<const NewStep> news, WayIndex way_after,
                       const Movable* crossing) {
  const Index after = first + count;
  const Cost bound = costOf(first, after + 1);
  if (crossing && crossing->cost() >= bound) return false;
  Trail trail;
  trail.add(nodeOf(first - 1));
  for (const NewStep& step : news) trail.add({step.option, step.legs, step.way, {}, {}});
  trail.add(nodeOf(after));
  trail.nodes[trail.size - 1].way = way_after;
  trail.changed = trail.size;  // the leg that follows stays as it is
  if (after + 1 < steps_.size()) trail.add(nodeOf(after + 1));
  if (!isCheaper(trail, bound) || (crossing && !crossing->isFree())) return false;
  for (std::size_t k = 1; k < trail.changed; ++k)
    if (!isLegFree(trail.nodes[k - 1], trail.nodes[k])) return false;
  if (!isCheaperFree(trail, bound)) return false;
  put(first, count, news, trail);
  return true;
}

bool Exchange::isCheaper(Trail& trail, Cost bound) {
  Cost sum;
  for (std::size_t k = 1; k < trail.size; ++k) {
    if (k < trail.changed) arrive(trail.nodes[k - 1], trail.nodes[k]);
    trail.links[k] = link(trail.nodes[k - 1], trail.nodes[k]);
    sum = sum + trail.links[k];
    if (sum >= bound) return false;
  }
  return true;
}

/// With changes of stance as far as they are free.
bool Exchange::isCheaperFree(Trail& trail, Cost bound) {
  Cost sum;
  for (std::size_t k = 1; k < trail.size; ++k) {
    trail.links[k] = freeLink(trail.nodes[k - 1], trail.nodes[k], kTurns_m);
    sum = sum + trail.links[k];
    if (sum >= bound) return false;
  }
  return true;
}

/// In which stance a step is come to from the one before.
void Exchange::arrive(const Node& before, Node& node) {
  node.arriving = before.leaving;
  if (!node.way) return;
  const Point from = before.option->out.position();
  const Point to = node.option->in.position();
  node.arriving = node.legs->stanceOn(std::atan2(to.y - from.y, to.x - from.x), *node.way);
}

/// The cost of coming to a step from the one before, and the stance in which it is left.
Cost Exchange::link(const Node& before, Node& node) {
  const Legs& legs = *node.legs;
  const Option& b = *node.option;
  const Point from = before.option->out.position();
  const Point to = b.in.position();
  Cost cost;
  if (node.way) {
    const double way_m = distance(from, to);
    if (way_m <= kSamePoint_m) return Cost::most();
    cost = legs.legCost(legs.ways()[*node.way], way_m) + legs.changeCost(before.leaving, node.arriving);
  } else if (!(from == to)) {
    return Cost::most();
  }
  node.leaving = node.arriving;
  if (b.is_stop) return cost;
  node.leaving = {b.any_heading ? node.arriving.yaw : b.out.yaw, b.out_mode};
  return cost + legs.changeCost(node.arriving, neededAt(node)) + b.cost;
}

/// The same with changes of stance as far as they are free, for a node whose stances are known.
Cost Exchange::freeLink(const Node& before, const Node& node, double least_m) {
  const Legs& legs = *node.legs;
  const Option& a = *before.option;
  const Option& b = *node.option;
  Cost cost;
  if (node.way)
    cost = legs.legCost(legs.ways()[*node.way], distance(a.out.position(), b.in.position())) +
           legs.freeChangeCost(a.out.position(), before.leaving, node.arriving, std::max(a.keep_m, least_m));
  if (b.is_stop) return cost;
  return cost +
         legs.freeChangeCost(b.in.position(), node.arriving, neededAt(node), std::max(b.keep_m, least_m)) +
         b.cost;
}

Stance Exchange::neededAt(const Node& node) {
  const Option& option = *node.option;
  return {option.any_heading ? node.arriving.yaw : option.in.yaw, option.in_mode};
}

bool Exchange::isLegFree(const Node& before, const Node& node) {
  if (!node.way) return true;
  const Option& a = *before.option;
  const Option& b = *node.option;
  return node.legs->isLegFree(node.legs->ways()[*node.way], a.out.position(), b.in.position(),
                              node.arriving.yaw, std::min(a.keep_m, b.keep_m));
}

/// Makes a change that has been worked out.
void Exchange::put(Index first, Index count, std::span<const NewStep> news, const Trail& trail) {
  const auto at = [first](auto& list) { return list.begin() + static_cast<std::ptrdiff_t>(first); };
  if (count > news.size()) {
    const auto gone = static_cast<std::ptrdiff_t>(count - news.size());
    steps_.erase(at(steps_), at(steps_) + gone);
    links_.erase(at(links_), at(links_) + gone);
  } else if (count < news.size()) {
    steps_.insert(at(steps_), news.size() - count, {});
    links_.insert(at(links_), news.size() - count, {});
  }
  for (std::size_t k = 0; k < news.size(); ++k)
    steps_[first + k] = {*news[k].option, news[k].legs, news[k].way, {}, {}};
  for (std::size_t k = 1; k < trail.size; ++k) {
    Passage::Step& step = steps_[first + k - 1];
    step.way = trail.nodes[k].way;
    step.arriving = trail.nodes[k].arriving;
    step.leaving = trail.nodes[k].leaving;
    links_[first + k - 1] = trail.links[k];
  }
}

}  // namespace underway
