#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/checker.hpp"
#include "local/command.hpp"
#include "local/guard.hpp"
#include "local/map_view.hpp"
#include "local/seen_floor.hpp"
#include "local/senses.hpp"
#include "local/window.hpp"
#include "planner/plan.hpp"

namespace underway {

struct SurroundingsSettings {
  double round_m = 2.5;          ///< how far round the plan the map is looked at [m]
  double believed_m = 2.5;       ///< what is seen further away is not sure enough to act upon [m]
  double sensor_sigma_m = 0.01;  ///< of what is near [m]
  double ahead_m = 1.0;          ///< how far ahead the lane has to be free of what is unmapped [m]
  double lane_margin_m = 0.03;   ///< to either side of the body [m]
};

/// What the robot sees that the map does not have, and what it must not run into.
class Surroundings {
 public:
  static constexpr double kUnseen_m = 0.03;  ///< kept from the middle of a cell of floor that was never seen
  static constexpr int kSettling = 20;       ///< ticks it stands still at first and learns where it is

  Surroundings(const SurroundingsSettings& settings, std::shared_ptr<const Robot> robot);

  /// A new plan: what the map has round it is expected to be seen. What was seen lately is kept.
  void expect(const World& map, const Plan& plan);
  /// Whoever plans knows what has been seen: it blocks nothing from now on, but the guard still keeps off it.
  void markKnown() { window_.markKnown(); }
  /// The plan's next segment is this clear: a third of it is kept from what the map has, as far as that was
  /// seen, 10 to 25 mm.
  void passBy(double clearance_m);
  /// What the senses tell, seen from a believed pose.
  void see(const Senses& senses, const Pose& from);

  /// Whether something unmapped stands in the lane of a translation's next stretch, from so far along it.
  [[nodiscard]] bool isLaneBlocked(const Motion& translation, double along_m) const;
  /// The same of all of it.
  [[nodiscard]] bool isWholeLaneBlocked(const Motion& translation) const;
  /// Whether something unmapped stands where the body turns about a point.
  [[nodiscard]] bool isTurnBlocked(const Pose& at) const;
  /// Whether something unmapped stands in a box round a pose: a switch's.
  [[nodiscard]] bool isBoxBlocked(const BodyBox& box, const Pose& at) const;
  /// Floor of the next stretch of a translation backwards that was not seen, or where the body can turn at
  /// its end, as far as the map has nothing there: the bearing of what takes the smallest turn to see, from
  /// the front at a pose [rad]. What the body stood on counts as seen.
  [[nodiscard]] std::optional<double> unseenBehind(const Motion& translation, double along_m,
                                                   const Pose& from) const;
  /// The smallest shift of the lane, at most `most_m` to either side, that is free; empty if none is.
  [[nodiscard]] std::optional<double> shiftAround(const Motion& translation, double along_m,
                                                  double most_m) const;
  /// The velocity as far as what is seen allows it: unmapped things are kept off by a margin; of mapped ones,
  /// which the plan passes as near as it says, only the body itself. Floor that was never seen is kept off
  /// too.
  [[nodiscard]] Velocity guarded(const Velocity& wanted) const;

  /// Where something unmapped was seen near a point: one for each cell.
  [[nodiscard]] std::vector<Point> surprisesNear(Point at, double reach_m) const;
  /// The middles of SeenFloor's cells near a point that were not seen and that the map has nothing on.
  [[nodiscard]] std::vector<Point> unseenNear(Point at, double reach_m) const;

 private:
  void standOn(const BodyBox& body, const Pose& at);
  void standFirstAt(double reach_m, Point at);
  void addUnseenFloor(const Pose& from);
  /// Calls `visit(cell)` for floor that was not seen in a box round a pose, and that the map has nothing on.
  template <class Visit>
  void visitUnseenIn(const BodyBox& box, const Pose& at, const Visit& visit) const;
  void addWhatWasSeen(const Pose& from);
  void look(const Scan& scan, const MapView& map, const Pose& from);
  void takeBack(const Scan& scan, const Pose& from);
  template <class Visit>
  void visitBeside(const Motion& translation, Range along, double reach_m, const Visit& visit) const;
  /// Of a translation, from so far along it: as far as it has to be free.
  [[nodiscard]] Range nextStretch(const Motion& translation, double along_m) const;
  [[nodiscard]] bool isBlockedAlong(const Motion& translation, Range along) const;
  /// To either side of a translation's line.
  [[nodiscard]] double halfLane(const Motion& translation) const;

  SurroundingsSettings settings_;
  std::shared_ptr<const Robot> robot_;
  MapView waist_map_;
  MapView head_map_;
  MapView depth_map_;
  Window window_;
  Window mapped_;  // what the map has, as it was seen close by
  SeenFloor floor_;
  Guard against_unmapped_;
  Guard against_remembered_;
  Guard against_unseen_;
  Guard against_mapped_;
  double reach_m_;        // as far as what lies on the floor can matter within a guard's horizon
  int stood_ = 0;         // ticks where it stood first
  std::size_t turn_ = 0;  // which of the beams are looked at for what is free
};

}  // namespace underway
