#pragma once

#include <optional>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/sites.hpp"

namespace underway {

/// Straight lines through places that only a lower mode passes, as crossings: a switch into the mode, a
/// translation, a switch out of it. A mode that cannot turn lives on such lines alone: two poses of it drawn
/// at random are never in line.
class Rails {
 public:
  using PlaceId = Draft::PlaceId;

  /// All must outlive it.
  Rails(const Checker& checker, Draft& draft, Sites& sites)
      : checker_(checker), draft_(draft), sites_(sites) {}

  /// The line through a free pose of a mode in a low place, along one of its senses: goes down as late as it
  /// can before it and gets up as early as it can after it. Returns the places that wait to be connected to
  /// the rest of the roadmap.
  std::vector<PlaceId> addThrough(ModeId mode, Sense sense, const Pose& pose);

  /// From a place where the robot is in a mode that cannot turn, after some motions that lead to a pose of
  /// that mode: where it gets up ahead.
  std::vector<PlaceId> addExits(PlaceId place, ModeId mode, Sense sense, const Pose& pose,
                                const Route& lead_in);
  /// To such a place: where it went down behind.
  std::vector<PlaceId> addEntries(PlaceId place, ModeId mode, Sense sense, const Pose& pose,
                                  const Route& lead_out);

  /// A line through a narrow place for a mode that turns: a place at the pose, and one on either side, as
  /// near as the mode can turn. All wait to be connected further.
  std::vector<PlaceId> addNarrow(ModeId mode, Sense sense, const Pose& pose);

  /// A way out of a place too tight to turn in: straight along a sense to where the mode can turn, or as far
  /// as it goes. The new places wait to be connected.
  std::vector<PlaceId> addWayOut(PlaceId place, ModeId mode, Sense sense, const Pose& pose);

 private:
  struct Line;

  /// The first position where a switch is free, from one where it is not, in a direction (1 or -1) along a
  /// line, to 0.1 mm; where it is free to begin with, the first one beyond what blocks it next.
  [[nodiscard]] std::optional<double> nextFree(const Line& line, const Switch& change, double from_m,
                                               double direction, double most_m) const;
  [[nodiscard]] bool isFreeAt(const Line& line, const Switch& change, double along_m) const;
  [[nodiscard]] double freeWay(const Line& line, double direction, double most_m) const;
  /// Down at one position on a line, along it, up at another; if that is free.
  void addPassage(const Line& line, const Switch& down, const Switch& up, double entry_m, double exit_m,
                  std::vector<PlaceId>& waiting);
  /// A place where a crossing begins or ends, with room to turn near it if there is any.
  PlaceId addEnd(ModeId mode, const Pose& pose, double direction, std::vector<PlaceId>& waiting);

  const Checker& checker_;
  Draft& draft_;
  Sites& sites_;
};

/// The obstacles that a mode may pass where another cannot: they hang above its body, lean over it, or are
/// low enough for it to step over. Indices into the world's obstacles.
[[nodiscard]] std::vector<std::size_t> overhangsFor(const World& world, const Robot& robot, ModeId mode);

}  // namespace underway
