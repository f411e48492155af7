#pragma once

#include <span>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/draft.hpp"

namespace underway {

/// Modes that change into each other where they stand, and turn: they share their positions. By mode,
/// ascending, the mode itself included; a mode that cannot turn has only itself.
[[nodiscard]] std::vector<std::vector<ModeId>> companionsOf(const Robot& robot);

/// Adds places to a draft and connects them. Growth, attachment and shortening all build through it; they
/// differ in where the places are and in when the connections are checked.
class Sites {
 public:
  using PlaceId = Draft::PlaceId;

  /// All must outlive it.
  Sites(const Checker& checker, Draft& draft, Draft::Check check);

  /// A position in a mode and all its companions. The place in `mode` comes first.
  std::vector<PlaceId> add(ModeId mode, Point at, double keep_m);

  /// Translations between two places of one mode, at each heading that its senses allow; those that are not
  /// free are left out (Check::kNow) or left to the search. Returns whether there are any.
  bool connect(PlaceId a, PlaceId b);
  /// The same to the best of several, nearest first: one in each direction of the compass, and all that join
  /// parts of the roadmap that were apart.
  void connectAround(PlaceId place, std::span<const PlaceId> neighbours);

 private:
  [[nodiscard]] bool isFree(PlaceId a, PlaceId b, double yaw, Sense sense) const;

  const Checker& checker_;
  Draft& draft_;
  Draft::Check check_;
  std::vector<std::vector<ModeId>> companions_;
};

}  // namespace underway
