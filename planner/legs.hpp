#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/cost.hpp"
#include "planner/route.hpp"

namespace underway {

/// One way to move along a leg: a mode and a sense.
struct Way {
  ModeId mode = 0;
  Sense sense = Sense::kForward;
  double angle_rad = 0.0;  ///< of the sense, from the front
  double us_per_m = 0.0;
};

/// Where the front points, and in which mode.
struct Stance {
  double yaw = 0.0;  ///< [rad]
  ModeId mode = 0;
};

/// The pieces that stretches of standing are made of: legs (translations from stop to stop) and the turns and
/// changes of mode at stops, in modes that change into each other where they stand. What they cost under one
/// policy, and whether they are free.
class Legs {
 public:
  /// Of one group. The checker must outlive it.
  Legs(const Checker& checker, Policy policy, double at_least_m, std::vector<ModeId> companions);

  [[nodiscard]] const std::vector<Way>& ways() const { return ways_; }
  [[nodiscard]] bool has(ModeId mode) const;
  /// Whether all modes have one body and change within it: then what a stance can change into is a matter of
  /// turning alone.
  [[nodiscard]] bool areAlike() const { return are_alike_; }
  [[nodiscard]] double atLeast() const { return at_least_m_; }
  /// The way back along a leg at the same heading, if its mode has that sense.
  [[nodiscard]] std::optional<std::size_t> opposite(std::size_t way) const { return opposite_[way]; }
  /// The heading and mode on a leg.
  [[nodiscard]] Stance stanceOn(double direction_rad, std::size_t way) const {
    return {normalizedAngle(direction_rad - ways_[way].angle_rad), ways_[way].mode};
  }
  /// Whether a leg covers the same ground when the robot faces the other way.
  [[nodiscard]] bool isSymmetric(std::size_t way) const;
  /// The first way whose legs cover the same ground as this one's: forward and backward, say.
  [[nodiscard]] std::size_t sameSweep(std::size_t way) const { return same_sweep_[way]; }

  /// Of a translation [m].
  [[nodiscard]] Cost legCost(const Way& way, double length_m) const {
    constexpr std::uint64_t kFewerLegs_us = 50'000;  // what a leg less is worth
    const Cost time = Cost::time(kFewerLegs_us + 1 + static_cast<std::uint64_t>(length_m * way.us_per_m));
    if (policy_ != Policy::kPriority || way.mode == 0) return time;
    return time + Cost::distance(way.mode, static_cast<std::uint32_t>(length_m * 1e3 + 0.5));
  }
  /// The least that a translation costs by any of some ways, of which there is one at least [m].
  [[nodiscard]] Cost cheapestLeg(std::uint32_t ways, double length_m) const {
    if (length_m >= kCounts_m)
      for (const std::size_t way : by_cost_)
        if ((ways >> way & 1U) != 0) return legCost(ways_[way], length_m);
    return cheapestShortLeg(ways, length_m);
  }
  /// The same by any way at all; 0 where there is none.
  [[nodiscard]] Cost cheapestLeg(double length_m) const;
  /// Whether a translation from a stop is free; keep_m: what its ends ask for (roadmap.hpp: isFreeKeeping).
  [[nodiscard]] bool isLegFree(const Way& way, Point from, Point to, double yaw, double keep_m) const;

  /// Of turning the short way and changing the mode, at one place. Headings closer than kSameYaw_rad are one.
  [[nodiscard]] Cost changeCost(const Stance& from, const Stance& to) const {
    const Change& change = changes_[from.mode * mode_count_ + to.mode];
    const double angle = std::abs(normalizedAngle(to.yaw - from.yaw));
    if (angle <= kSameYaw_rad) return change.cost;
    if (!(change.us_per_rad > 0.0)) return Cost::most();  // cannot turn
    return change.cost + Cost::time(1 + static_cast<std::uint64_t>(angle * change.us_per_rad));
  }
  /// As much as the short way from any stance to any other can cost.
  [[nodiscard]] Cost dearestChange() const { return dearest_; }
  /// The motions of the cheapest free change at a place; empty when none is.
  [[nodiscard]] std::optional<Route> change(Point at, const Stance& from, const Stance& to,
                                            double keep_m) const;
  [[nodiscard]] bool isChangeFree(Point at, const Stance& from, const Stance& to, double keep_m) const;
  /// The cost of that change; Cost::most() when none is free.
  [[nodiscard]] Cost freeChangeCost(Point at, const Stance& from, const Stance& to, double keep_m) const;

  /// How far a stance can be turned, each way; all of it where nothing is near.
  [[nodiscard]] TurningRoom roomAt(Point at, const Stance& stance, double keep_m) const;
  /// As freeChangeCost, from a stance with known room.
  [[nodiscard]] Cost freeChangeCost(Point at, const Stance& from, const TurningRoom& room, const Stance& to,
                                    double keep_m) const;
  /// Whether any change is free at a place, judged by the circle round the body: `false` may still leave
  /// some.
  [[nodiscard]] bool turnsFreely(Point at, double keep_m) const;

  static constexpr double kSameYaw_rad = 1e-11;
  static constexpr std::size_t kMostWays = kMaxModes * kSenses.size();

 private:
  static constexpr double kCounts_m = 1e-3;  // shorter legs may round to no distance
  /// How one mode becomes another, and in which of the two to turn.
  struct Change {
    std::vector<ModeId> via;  // modes after the first, the last included
    Cost cost;                // of the switches
    double us_per_rad = 0.0;  // of turning
    bool turns_first = true;
    bool is_covered = true;  // each switch is free where the first or the last mode's body is
  };
  [[nodiscard]] Cost cheapestShortLeg(std::uint32_t ways, double length_m) const;
  [[nodiscard]] bool coverTheSame(const Way& a, const Way& b) const;
  [[nodiscard]] Change changeBetween(ModeId from, ModeId to) const;
  /// Whether a switch keeps within a mode's body and sees nothing that the mode steps over.
  [[nodiscard]] bool isCoveredBy(const Switch& change, ModeId mode) const;
  [[nodiscard]] double clearanceFor(double keep_m) const;
  [[nodiscard]] bool isFree(const Motion& motion, double keep_m) const;
  [[nodiscard]] std::optional<Route> changeBy(Point at, const Stance& from, const Stance& to,
                                              double angle_rad, double keep_m) const;

  const Checker& checker_;
  const Robot& robot_;
  std::size_t mode_count_;
  Policy policy_;
  double at_least_m_;
  std::vector<ModeId> companions_;
  std::vector<Way> ways_;
  std::vector<std::size_t> same_sweep_;               // by way
  std::vector<std::optional<std::size_t>> opposite_;  // by way
  std::vector<std::size_t> by_cost_;  // ways, the cheapest first, at any length that is not next to nothing
  Cost dearest_;
  bool are_alike_ =
      true;  // all companions have one body, and changes of mode keep within it: room is all that matters
  std::vector<Change> changes_;  // by from * modes + to
};

}  // namespace underway
