#pragma once

#include <array>
#include <span>
#include <vector>

#include "planner/exchange.hpp"
#include "planner/interrupt.hpp"
#include "planner/movable.hpp"
#include "planner/passage.hpp"

namespace underway {

/// Improves a passage by one small change at a time, each of which is kept if it is free and makes the
/// passage cheaper (Exchange). Coarse steps move a stop and choose the ways to it and on anew, move both
/// stops of a leg, leave a stop out, put one into a leg, or two in the place of one, which cuts a corner; a
/// leg between crossings takes another way. Fine steps move stops, but do all the rest too next to legs that
/// the policy counts before any time. Both move crossings, by themselves or with the stop next to them. Only
/// what lies next to a change is tried again.
class Nudge {
 public:
  /// The passage is free, and `crossings` says what its crossings keep. The checker and the legs of the
  /// passage must outlive it.
  Nudge(const Movable::Rules& crossings, Passage passage);
  Nudge(const Nudge&) = delete;
  Nudge& operator=(const Nudge&) = delete;

  /// Changes of one step size, until none helps any more.
  void by(double step_m, Interrupt& interrupt);
  [[nodiscard]] Passage passage() && { return std::move(passage_).passage(); }

 private:
  using Index = Exchange::Index;
  using NewStep = Exchange::NewStep;
  using Directions = std::array<Point, 8>;

  bool improveAt(Index i, double step_m);
  [[nodiscard]] bool isNextToAside(Index i) const;
  [[nodiscard]] Directions directionsAt(Index first, Index last) const;
  bool moveStop(Index i, double step_m);
  bool moveLeg(Index i, double step_m);
  bool moveCrossing(Index i, double step_m);
  bool putCrossing(Index i, const Movable& moved);
  bool putCrossingAndStop(Index i, const Movable& moved);
  [[nodiscard]] bool isStopOnLegs(Index i) const;
  bool leaveOut(Index i);
  bool changeWay(Index i);
  bool putStopInto(Index i);
  bool cutCorner(Index i, double step_m);
  bool replace(Index first, Index count, std::span<const NewStep> news, Exchange::WayIndex way_after,
               const Movable* crossing = nullptr);
  bool rejoin(Index first, Index count, const Option& stop);
  bool refresh(Index first, Index gone, Index come);
  void markNear(Index i);

  const Robot& robot_;
  Movable::Rules rules_;
  Exchange passage_;
  const std::vector<Passage::Step>& steps_;  // of it
  std::vector<char> fresh_;  // a change may help: something near has changed since it was tried
};

}  // namespace underway
