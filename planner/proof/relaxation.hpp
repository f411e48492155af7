#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/plan.hpp"
#include "planner/proof/cell_tree.hpp"
#include "planner/proof/stances.hpp"
#include "planner/proof/survey.hpp"

namespace underway::proof {

/// A world in which the robot may do everything it may do in the real one, and more: poses are cells, and a
/// cell is closed only if no pose in it is free. So what cannot be reached here cannot be reached at all.
///
/// - Within a stance a robot goes from a cell to any open neighbour that lies in the direction of one of its
///   senses, at some heading of the cell. How far it drifts, and that it goes straight, is forgotten.
/// - A switch is open in a cell unless its box is blocked at all poses of it; it leads to all cells that hold
///   one of the displaced poses, also to closed ones if another switch leads on from there.
///
/// A value: a copy goes its own way.
class Relaxation {
 public:
  /// One cell in one stance.
  struct Place {
    std::uint32_t stance = 0;
    CellId cell = 0;
    bool operator==(const Place&) const = default;
  };

  /// Every obstacle is kept `margin_m` from. When interrupted it is of no use.
  Relaxation(const Checker& checker, const Request& request, double margin_m, Interrupt& interrupt);

  [[nodiscard]] const Stances& stances() const { return stances_; }
  [[nodiscard]] const Stance& stance(const Place& place) const { return stances_.all[place.stance]; }
  [[nodiscard]] const CellTree& cells(std::size_t stance) const { return floors_[stance].cells; }
  [[nodiscard]] std::size_t size() const;  ///< cells in all

  /// Of the body; of the switch that is the exit-th of the stance's.
  [[nodiscard]] const Outlook& ofBody(const Place& place) const { return outlook(place, 0); }
  [[nodiscard]] const Outlook& ofExit(const Place& place, std::size_t exit) const {
    return outlook(place, exit + 1);
  }
  /// How large a cell is, as far as it matters to the body [m].
  [[nodiscard]] double extentOf(const Place& place) const {
    return floors_[place.stance].extents_m[place.cell];
  }

  /// Cells with the start's pose in them.
  [[nodiscard]] std::span<const Place> starts() const { return starts_; }
  /// Whether some pose of a cell is within the tolerance of a goal.
  [[nodiscard]] bool isGoal(const Place& place) const;
  /// Whether one of the stance's senses leads from a cell to a neighbour.
  [[nodiscard]] bool leadsTo(const Place& from, CellId neighbour) const;
  /// Appends the cells that a switch leads to.
  void findBeyond(const Place& from, std::size_t exit, std::vector<CellId>& found) const;

  /// Halves a cell: it keeps the lower half, and the upper one is returned.
  CellId split(const Place& place, std::size_t axis, Interrupt& interrupt);
  [[nodiscard]] bool canSplit(const Place& place, std::size_t axis) const {
    return cells(place.stance).canSplit(place.cell, axis);
  }
  /// The axis along which a cell's corners are furthest apart.
  [[nodiscard]] std::size_t longestAxis(const Place& place) const;

  /// Takes obstacles away, as indices into the world's; from one shape only, or from all.
  void lift(std::span<const std::size_t> obstacles, std::optional<std::size_t> shape, Interrupt& interrupt);
  /// The obstacles of which each alone blocks a cell's body, or its switch.
  [[nodiscard]] std::vector<std::size_t> blockersOfBody(const Place& place);
  [[nodiscard]] std::vector<std::size_t> blockersOfExit(const Place& place, std::size_t exit);

 private:
  struct End {
    std::uint32_t stance;
    CellBox box;
  };
  struct Floor {
    CellTree cells;
    std::vector<double> extents_m;  // of each cell
    std::vector<Outlook> outlooks;  // of each cell: of the body, then of the exits
  };

  [[nodiscard]] std::size_t slots(std::size_t stance) const { return stances_.all[stance].exits.size() + 1; }
  [[nodiscard]] std::size_t shapeOf(std::size_t stance, std::size_t slot) const {
    return slot == 0 ? stances_.all[stance].shape : stances_.all[stance].exits[slot - 1].shape;
  }
  [[nodiscard]] const Outlook& outlook(const Place& place, std::size_t slot) const {
    return floors_[place.stance].outlooks[place.cell * slots(place.stance) + slot];
  }
  [[nodiscard]] double measured(const Place& place) const;
  void findStarts();

  Stances stances_;
  Survey survey_;
  std::vector<Floor> floors_;
  std::vector<double> reach_m_;  // of each stance's body
  Pose start_;                   // in the corner's frame
  std::uint32_t start_stance_;
  std::vector<End> goals_;
  std::vector<Place> starts_;
};

}  // namespace underway::proof
