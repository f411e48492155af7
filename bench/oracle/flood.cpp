#include "bench/oracle/flood.hpp"

#include <algorithm>

namespace underway::bench {

Flood::Flood(Lattice& lattice, const std::vector<Spur>& sources, const Progress& progress,
             const std::vector<Spur>& goals)
    : lattice_(&lattice),
      cost_(lattice.size(), Cost::most()),
      from_(lattice.size(), kNowhere),
      step_(lattice.size(), kNone) {
  for (const Spur& source : sources)
    if (reach(source.node, source.cost, kNowhere, kJump)) jump_[source.node] = source.route;
  spread(progress, goals);
}

bool Flood::reach(Lattice::Node node, Cost cost, Lattice::Node from, Lattice::Step step) {
  if (cost >= cost_[node]) return false;
  cost_[node] = cost;
  from_[node] = from;
  step_[node] = step;
  heap_.push_back({cost, node});
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  return true;
}

const Spur* Flood::best(const std::vector<Spur>& goals) const {
  const Spur* best = nullptr;
  Cost least = Cost::most();
  for (const Spur& goal : goals)
    if (cost_[goal.node] != Cost::most() && cost_[goal.node] + goal.cost < least) {
      least = cost_[goal.node] + goal.cost;
      best = &goal;
    }
  return best;
}

void Flood::spread(const Progress& progress, const std::vector<Spur>& goals) {
  std::unordered_map<Lattice::Node, Cost> ways_on;  // the cheapest from each node
  for (const Spur& goal : goals) {
    const auto [known, is_new] = ways_on.try_emplace(goal.node, goal.cost);
    if (!is_new) known->second = std::min(known->second, goal.cost);
  }
  Cost enough = Cost::most();
  constexpr std::size_t kRoundsPerTelling = 1 << 16;
  std::size_t settled = 0;
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const Waiting next = heap_.back();
    heap_.pop_back();
    if (next.cost > cost_[next.node]) continue;
    if (next.cost >= enough) return;
    if (const auto way = ways_on.find(next.node); way != ways_on.end())
      enough = std::min(enough, next.cost + way->second);
    if (++settled % kRoundsPerTelling == 0 && progress)
      progress(static_cast<double>(settled) / static_cast<double>(lattice_->size()));
    relaxSteps(next.node);
    if (lattice_->settings().has_bridges) relaxBridges(next.node);
  }
}

void Flood::relaxSteps(Lattice::Node node) {
  for (Lattice::Step step = 0; step < Lattice::kSteps; ++step)
    if (const auto to = lattice_->stepped(node, step))
      reach(*to, cost_[node] + lattice_->cost(node, step), node, step);
}

void Flood::relaxBridges(Lattice::Node node) {
  for (Spur& bridge : bridgesFrom(*lattice_, node))
    if (reach(bridge.node, cost_[node] + bridge.cost, node, kJump))
      jump_[bridge.node] = std::move(bridge.route);
}

Route Flood::route(Lattice::Node node) const {
  Route backwards;
  while (node != kNowhere) {
    const Lattice::Node from = from_[node];
    if (step_[node] == kJump) {
      const Route& jump = jump_.at(node);
      backwards.insert(backwards.end(), jump.rbegin(), jump.rend());
    } else {
      backwards.push_back(lattice_->motion(from, step_[node], node));
    }
    node = from;
  }
  return {backwards.rbegin(), backwards.rend()};
}

}  // namespace underway::bench
