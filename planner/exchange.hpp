#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "planner/movable.hpp"
#include "planner/passage.hpp"

namespace underway {

/// A passage whose steps may be exchanged for others, if all that this touches is free and costs less than
/// before. Only what lies next to a change is worked out, so that it costs the same on long ways and on short
/// ones: costs first, then legs, then changes of stance.
class Exchange {
 public:
  using Index = std::size_t;
  using WayIndex = std::optional<std::size_t>;
  /// A step, and how it is come to.
  struct NewStep {
    const Option* option = nullptr;
    const Legs* legs = nullptr;
    WayIndex way;
  };
  /// The passage is free. Its legs must outlive it.
  explicit Exchange(Passage passage);

  [[nodiscard]] const std::vector<Passage::Step>& steps() const { return steps_; }
  [[nodiscard]] Passage passage() &&;

  /// Puts up to two steps in the place of `count` from `first` on, with a way for the leg that follows, and
  /// tells whether it did. A crossing among them is asked whether it is free itself.
  bool replace(Index first, Index count, std::span<const NewStep> news, WayIndex way_after,
               const Movable* crossing = nullptr);
  /// Puts a stop in the place of one or of none, with ways to it and on from it as they cost less and are
  /// free.
  bool rejoin(Index first, Index count, const Option& stop);

 private:
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
    std::size_t changed = 0;  // from here on legs are as they were
    void add(const Node& node) { nodes[size++] = node; }
  };

  /// Ways to a stop and on from it, and what they cost at least.
  struct WayPair {
    Index to = 0;
    Index on = 0;
    Cost cost;
  };
  /// A way on from a stop, and what it costs.
  struct Onward {
    Stance stance;
    Cost cost;
  };
  using Onwards = std::array<Onward, Legs::kMostWays>;

  [[nodiscard]] Node nodeOf(Index i) const;
  [[nodiscard]] std::vector<WayPair> cheaperPairs(Index first, Index count, const Option& stop) const;
  [[nodiscard]] Onwards onwardsFrom(const Option& stop, Index to_step) const;
  [[nodiscard]] Cost costOf(Index first, Index last) const;
  void put(Index first, Index count, std::span<const NewStep> news, const Trail& trail);
  static bool isCheaper(Trail& trail, Cost bound);
  static bool isCheaperFree(Trail& trail, Cost bound);
  static void arrive(const Node& before, Node& node);
  static Cost link(const Node& before, Node& node);
  static Cost freeLink(const Node& before, const Node& node, double least_m);
  static Stance neededAt(const Node& node);
  static bool isLegFree(const Node& before, const Node& node);

  std::vector<Passage::Step> steps_;
  std::vector<Cost> links_;  // from the step before: change, leg, change and the option's motions
};

}  // namespace underway
