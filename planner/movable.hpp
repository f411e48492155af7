#pragma once

#include <array>
#include <optional>

#include "planner/legs.hpp"

namespace underway {

/// A part of a route that no choice of headings can change: a switch that moves the robot, or a straight way
/// in a mode that cannot turn, with the switches before and after it. It can be moved as a whole, turned,
/// made longer and shorter.
class Movable {
 public:
  /// What the motions keep: as Legs, with the start's and the goal's clearance where they begin or end there.
  struct Rules {
    const Checker* checker = nullptr;
    Policy policy = Policy::kPriority;
    double at_least_m = 0.0;
  };

  /// Motions as a route has them. Fixed ends cannot be moved: where the route starts or ends in it.
  Movable(const Rules& rules, Route motions, bool is_start, bool is_goal, double start_m, double goal_m);

  [[nodiscard]] const Route& motions() const { return motions_; }
  [[nodiscard]] Cost cost() const { return cost_; }
  [[nodiscard]] const Pose& entry() const { return motions_.front().from; }
  [[nodiscard]] const Pose& exit() const { return motions_.back().to; }

  /// Ways to change it, by a step: kAhead..kTurned move all of it, the others one end along its line.
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
  /// The crossing after a move; empty where that makes no sense. Not checked yet.
  [[nodiscard]] std::optional<Movable> moved(Move move, double step_m) const;
  [[nodiscard]] bool isFree() const;

 private:
  [[nodiscard]] std::optional<std::size_t> line() const;
  [[nodiscard]] std::optional<Movable> rebuilt(const Pose& line_from, double length_m) const;

  Rules rules_;
  Route motions_;
  bool is_start_;
  bool is_goal_;
  double start_m_;
  double goal_m_;
  Cost cost_;
};

}  // namespace underway
