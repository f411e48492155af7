#pragma once

#include <functional>
#include <unordered_map>
#include <vector>

#include "bench/oracle/bridges.hpp"
#include "bench/oracle/lattice.hpp"

namespace underway::bench {

/// Told now and then while something long goes on: the share that is done, 0..1.
using Progress = std::function<void(double)>;

/// The cheapest way on the lattice from a start to every node, by Dijkstra.
class Flood {
 public:
  /// The lattice must outlive it; its steps are checked as they are needed. With `goals`, the ways that lead
  /// on from nodes to one goal, it ends as soon as nothing cheaper leads to the goal.
  Flood(Lattice& lattice, const std::vector<Spur>& sources, const Progress& progress = {},
        const std::vector<Spur>& goals = {});

  /// The best of the goals, after its end; none can be reached: nullptr.
  [[nodiscard]] const Spur* best(const std::vector<Spur>& goals) const;

  /// Cost::most() if it cannot be reached.
  [[nodiscard]] Cost cost(Lattice::Node node) const { return cost_[node]; }
  /// From the start to a node that can be reached; without the switches between companions.
  [[nodiscard]] Route route(Lattice::Node node) const;

 private:
  struct Waiting {
    Cost cost;
    Lattice::Node node;
    bool operator>(const Waiting& other) const { return cost > other.cost; }
  };
  static constexpr Lattice::Step kJump = 0xfe;  // by a bridge or from the start: jump_ has the route
  static constexpr Lattice::Step kNone = 0xff;
  static constexpr Lattice::Node kNowhere = ~Lattice::Node{0};

  void spread(const Progress& progress, const std::vector<Spur>& goals);
  void relaxSteps(Lattice::Node node);
  void relaxBridges(Lattice::Node node);
  bool reach(Lattice::Node node, Cost cost, Lattice::Node from, Lattice::Step step);

  Lattice* lattice_;
  std::vector<Cost> cost_;
  std::vector<Lattice::Node> from_;
  std::vector<Lattice::Step> step_;
  std::unordered_map<Lattice::Node, Route> jump_;
  std::vector<Waiting> heap_;
};

}  // namespace underway::bench
