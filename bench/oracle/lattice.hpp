#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bench/oracle/gaits.hpp"
#include "bench/oracle/headings.hpp"
#include "geometry/checker.hpp"
#include "planner/cost.hpp"

namespace underway::bench {

struct LatticeSettings {
  double cell_m = 0.025;  ///< between neighbours
  int headings = 64;
  double margin_m = 0.0;  ///< kept everywhere on the lattice
  Policy policy = Policy::kFastest;
  bool has_bridges = true;  ///< whether it may change gaits; walls of full height give no reason to
};

/// Every free pose of every gait that turns, at the middles of cells and at headings along which cells line
/// up, and the exactly checked steps between them: one vector of cells to one of the body's sides, or a turn
/// to the next heading. Steps are checked when they are first asked for. For one thread.
class Lattice {
 public:
  using Node = std::uint32_t;
  /// 0..3: to a side, by Sense; then the turns.
  using Step = std::uint8_t;
  static constexpr Step kCounterClockwise = 4;
  static constexpr Step kClockwise = 5;
  static constexpr Step kSteps = 6;

  struct Cell {
    int x = 0;
    int y = 0;
    bool operator==(const Cell&) const = default;
  };

  /// The checker must outlive it.
  Lattice(const Checker& checker, const LatticeSettings& settings);

  [[nodiscard]] const Checker& checker() const { return *checker_; }
  [[nodiscard]] const LatticeSettings& settings() const { return settings_; }
  [[nodiscard]] const Gaits& gaits() const { return gaits_; }
  [[nodiscard]] const std::vector<Heading>& headings() const { return headings_; }
  [[nodiscard]] Node size() const { return static_cast<Node>(spots_.size() * headings_.size()); }

  [[nodiscard]] Pose pose(Node node) const;
  [[nodiscard]] GaitId gait(Node node) const { return spots_[node / headings_.size()].gait; }
  [[nodiscard]] int heading(Node node) const { return static_cast<int>(node % headings_.size()); }
  [[nodiscard]] Cell cell(Node node) const { return spots_[node / headings_.size()].cell; }
  /// The node there, if the body is free there.
  [[nodiscard]] std::optional<Node> find(GaitId gait, Cell cell, int heading) const;

  /// A point in cells: whole numbers are the middles of cells.
  [[nodiscard]] Point inCells(Point at) const;
  [[nodiscard]] Point at(Cell cell) const;
  /// Index of the heading next to a yaw.
  [[nodiscard]] int nearestHeading(double yaw) const;
  [[nodiscard]] double yawOf(int heading) const;

  /// Where a free step leads; empty if it is not free or the gait does not have it.
  [[nodiscard]] std::optional<Node> stepped(Node node, Step step);
  [[nodiscard]] Motion motion(Node from, Step step, Node to) const;
  /// Whether a switch to another gait, by its index into Robot::switches, is free from a node.
  [[nodiscard]] bool maySwitch(Node node, std::size_t change);
  [[nodiscard]] Cost cost(Node from, Step step) const {
    return cost_[(std::size_t{gait(from)} * headings_.size() + from % headings_.size()) * kSteps + step];
  }

 private:
  struct Spot {
    Cell cell;
    GaitId gait = 0;
    bool is_free_all_round = false;
    std::uint64_t free = 0;  ///< by heading
  };
  void placeGait(GaitId gait);
  [[nodiscard]] std::uint64_t freeHeadings(GaitId gait, Cell cell) const;
  void costSteps();
  [[nodiscard]] std::optional<Node> neighbour(Node node, Step step) const;
  [[nodiscard]] std::uint8_t checkedSteps(Node node) const;
  [[nodiscard]] std::uint64_t checkedSwitches(Node node) const;

  const Checker* checker_;
  LatticeSettings settings_;
  Gaits gaits_;
  std::vector<Heading> headings_;
  int columns_;
  int rows_;
  std::vector<std::vector<std::int32_t>> spot_of_cell_;  // by gait; empty if it does not turn; -1: not free
  std::vector<Spot> spots_;
  std::vector<std::uint8_t> free_steps_;      // by node; kNotChecked at first
  std::vector<std::uint64_t> free_switches_;  // by node, by index; kNotChecked at first
  std::vector<Cost> cost_;                    // by gait, heading and step
};

}  // namespace underway::bench
