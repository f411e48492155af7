#pragma once

#include <array>
#include <optional>
#include <span>

#include "geometry/checker.hpp"
#include "planner/passage.hpp"
#include "planner/route.hpp"

namespace underway {

/// A crossing that shortening may change: move it as a whole, turn it, make its line longer or shorter at
/// either end. What it consists of stays the same: a lone switch, or a straight line with switches before and
/// after it.
class Movable {
 public:
  /// What the motions keep: as legs do, with the start's and the goal's clearance where the route begins or
  /// ends in them.
  struct Rules {
    const Checker* checker = nullptr;
    Policy policy = Policy::kPriority;
    double at_least_m = 0.0;
    double start_m = 0.0;
    double goal_m = 0.0;
    bool is_start = false;  ///< the route starts in it: its entry stays where it is
    bool is_goal = false;   ///< the route ends in it: its exit stays where it is

    /// Those of the i-th step: of a mode that cannot turn, what begins at the start or ends at the goal stays
    /// there.
    [[nodiscard]] Rules at(std::span<const Passage::Step> steps, std::size_t i) const;
  };

  Movable(const Rules& rules, Route motions);

  [[nodiscard]] const Route& motions() const { return motions_; }
  [[nodiscard]] Cost cost() const { return cost_; }
  [[nodiscard]] const Pose& entry() const { return motions_.front().from; }
  [[nodiscard]] const Pose& exit() const { return motions_.back().to; }

  /// The first six move all of it, the others one end along its line.
  enum class Move {
    kAhead,
    kBack,
    kLeft,
    kRight,
    kTurnedLeft,
    kTurnedRight,
    kLaterEntry,
    kEarlierEntry,
    kLaterExit,
    kEarlierExit
  };
  static constexpr std::array kMoves{
      Move::kAhead,       Move::kBack,       Move::kLeft,         Move::kRight,     Move::kTurnedLeft,
      Move::kTurnedRight, Move::kLaterEntry, Move::kEarlierEntry, Move::kLaterExit, Move::kEarlierExit};
  /// What it becomes by a move of a step; empty where that makes no sense. Not checked yet.
  [[nodiscard]] std::optional<Movable> moved(Move move, double step_m) const;
  [[nodiscard]] bool isFree() const;
  /// As a step of a passage.
  [[nodiscard]] Option option() const;

 private:
  [[nodiscard]] std::optional<std::size_t> line() const;
  [[nodiscard]] std::optional<Movable> shifted(const Pose& by) const;
  [[nodiscard]] std::optional<Movable> withEntry(double later_m) const;
  [[nodiscard]] std::optional<Movable> withExit(double later_m) const;
  [[nodiscard]] Movable withLine(std::size_t line, const Pose& from, double length_m) const;

  Rules rules_;
  Route motions_;
  Cost cost_;
};

}  // namespace underway
