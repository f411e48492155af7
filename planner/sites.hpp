#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "planner/draft.hpp"
#include "planner/stances.hpp"

namespace underway {

/// Adds places to a draft and connects them. Growth and attachment build through it; they differ in where the
/// places are and in when the legs are checked.
class Sites {
 public:
  using PlaceId = Draft::PlaceId;
  enum class Check { kNow, kWhenUsed };

  /// All must outlive it.
  Sites(const Stances& stances, Draft& draft, Check check);

  /// A position for a mode and all its companions.
  PlaceId add(ModeId mode, Point at, double keep_m);

  /// Legs between two places of one group, by each way that is free (Check::kNow) or that the search may try.
  /// Returns whether there are any.
  bool connect(PlaceId a, PlaceId b);
  /// The same to the best of several, nearest first: one in each direction of the compass, and all that join
  /// parts of the roadmap that were apart.
  void connectAround(PlaceId place, std::span<const PlaceId> neighbours);

 private:
  const Stances& stances_;
  Draft& draft_;
  Check check_;
};

/// Which ways of legs between two points are free, keeping a clearance; those of legs the other way are taken
/// over where they cover the same ground.
[[nodiscard]] Roadmap::Ways freeWays(const Legs& legs, Point from, Point to, double keep_m,
                                     const Roadmap::Ways* back);

}  // namespace underway
