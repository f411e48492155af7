#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "planner/interrupt.hpp"
#include "planner/proof/relaxation.hpp"

namespace underway::proof {

/// A cell on a way, and how the way leaves it: by an exit, or to a neighbour.
struct Step {
  Relaxation::Place place;
  std::optional<std::uint32_t> exit;  ///< index into the stance's exits
};
struct Way {
  std::vector<Step> steps;
  double cost = 0.0;  ///< grows with the number of undecided cells and with how small they are
};
/// Of an obstacle.
using Weight = std::function<double(std::size_t)>;

/// Looks for ways from start to goal (Dijkstra 1959), again and again while cells are halved. Nothing is
/// found if there is none, or when interrupted (ask the interrupt).
class WaySearch {
 public:
  /// Through open cells; of all ways the one through the fewest and largest undecided ones.
  [[nodiscard]] std::optional<Way> throughOpenCells(const Relaxation& relaxation, Interrupt& interrupt);

  /// From now on only through the cells of a way and the halves of them, all of which must be told of: that
  /// is quick.
  void confineTo(const Relaxation& relaxation, const Way& way);
  /// Through those beside its undecided ones too.
  void letBeside(const Relaxation& relaxation, const Way& way);
  void noteHalves(const Relaxation::Place& lower, CellId upper);
  /// From now on through all cells again.
  void goAnywhere() { is_confined_ = false; }

  /// The obstacles, as indices into the world's, that are on the way on which they weigh least.
  [[nodiscard]] std::optional<std::vector<std::size_t>> fewestBlockers(Relaxation& relaxation,
                                                                       const Weight& weight,
                                                                       Interrupt& interrupt);

 private:
  struct Known {
    double cost;
    Step before;
    std::uint32_t round = 0;  // of searching; what is left of an earlier one does not count
    bool is_start;
  };
  template <class Costs>
  class Run;

  std::vector<std::vector<Known>> known_;  // by stance and cell; kept, so that a search allocates little
  std::uint32_t round_ = 0;
  bool is_confined_ = false;
  std::vector<std::vector<char>> is_within_;  // by stance and cell, if confined
};

}  // namespace underway::proof
