#pragma once

#include <array>
#include <span>
#include <vector>

#include "planner/interrupt.hpp"
#include "planner/movable.hpp"
#include "planner/passage.hpp"

namespace underway {

/// Improves a passage by one small change at a time, each of which is kept if it is free and makes the
/// passage cheaper: a stop, a crossing or both stops of a leg are moved by a step; one leg or the two at a
/// stop take other ways; a stop is left out, or put into a leg. Only what lies next to a change is worked out
/// anew, so that a change costs the same on long ways and on short ones.
class Nudge {
 public:
  /// The passage is free, and `crossings` says what its crossings keep. The checker and the legs of the
  /// passage must outlive it.
  Nudge(const Movable::Rules& crossings, Passage passage);

  /// Changes of one step size, until none helps any more.
  void by(double step_m, Interrupt& interrupt);
  [[nodiscard]] Passage passage() &&;

 private:
  using Index = std::size_t;
  using WayIndex = std::optional<std::size_t>;
  enum class Rigour { kCostsOnly, kFree };

  /// A step of the passage, or one to take its place.
  struct Node {
    const Option* option = nullptr;
    const Legs* legs = nullptr;
    WayIndex way;
    Stance arriving;
    Stance leaving;
  };
  static constexpr std::size_t kMostNew = 2;
  /// What a change touches: the step before it, the new steps, and the two after it.
  struct Trail {
    std::array<Node, kMostNew + 3> nodes;
    std::array<Cost, kMostNew + 3> links;
    std::size_t size = 0;
    void add(const Node& node) { nodes[size++] = node; }
  };

  [[nodiscard]] Node nodeOf(Index i) const;
  bool improveAt(Index i, double step_m);
  bool moveStop(Index i, double step_m);
  bool moveLeg(Index i, double step_m);
  bool moveCrossing(Index i, double step_m);
  bool leaveOut(Index i);
  bool changeWay(Index i);
  bool changeWaysRound(Index i);
  bool putStopInto(Index i, double step_m);
  bool putStop(Index i, Point at);
  /// Puts new steps in the place of `count` from `first` on, with a way for the leg that follows. A crossing
  /// among them is asked whether it is free itself.
  bool replace(Index first, Index count, std::span<const Node> news, WayIndex way_after,
               const Movable* crossing = nullptr);
  void put(Index first, Index count, std::span<const Node> news, const Trail& trail);
  static bool mayBeCheaper(const Trail& trail, Cost bound);
  static bool isCheaper(Trail& trail, Cost bound, Rigour rigour);
  static Cost link(const Node& before, Node& node, Rigour rigour);
  void markNear(Index i);

  const Robot& robot_;
  Movable::Rules rules_;
  std::vector<Passage::Step> steps_;
  std::vector<Cost> links_;  // from the step before: change, leg, change and the option's motions
  std::vector<char> fresh_;  // a change may help: something near has changed since it was tried
};

}  // namespace underway
