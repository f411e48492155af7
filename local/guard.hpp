#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/pose.hpp"
#include "local/command.hpp"
#include "local/scan.hpp"

namespace underway {

struct GuardSettings {
  double margin_m = 0.04;    ///< kept between body and what was seen, at most [m]
  double horizon_s = 1.0;    ///< how far ahead a velocity is looked at [s]
  double least_m = 0.0;      ///< kept from each point for itself, however near others are [m]
  double fastest_mps = 0.2;  ///< of the robot: what is further than it leads to cannot matter [m/s]
};

/// The last word on a velocity: never one that brings the body nearer to what was seen than a margin. Knows
/// neither goals nor plans. Bounded time; allocates only when made.
class Guard {
 public:
  Guard(const GuardSettings& settings, const BodyBox& body, std::size_t most_points);

  /// What was seen this tick, in the body frame; only what is near is kept.
  void look(const Scan& scan);
  void add(Point point);
  void clear() { points_.clear(); }
  /// From now on it keeps this margin, at most that of its settings.
  void keep(double margin_m) { margin_m_ = std::min(margin_m, settings_.margin_m); }

  /// The wanted velocity, a share of it, its turn alone, or none. Nearer than the margin already, what brings
  /// it no nearer is allowed, so that it goes on along what it stands beside; but one point that noise has
  /// put close to the body, or into it, does not let it near the others: see `least_m`.
  [[nodiscard]] Velocity allowed(const Velocity& wanted) const;
  /// Whether a velocity is one that it allows.
  [[nodiscard]] bool allows(const Velocity& velocity) const;
  /// From the body to the nearest point, after moving at a velocity for a time [m]. Negative inside the body.
  [[nodiscard]] double distanceAfter(const Velocity& velocity, double time_s) const;
  /// Straight away from the nearest point, at a speed [m/s].
  [[nodiscard]] Velocity retreat(double speed_mps) const;

 private:
  /// The same, but for what is further than `most_m`: told as that.
  [[nodiscard]] double distanceAfter(const Velocity& velocity, double time_s, double most_m) const;
  /// Whether any point comes nearer than is needed, and nearer than it is.
  [[nodiscard]] bool bringsNearer(const Velocity& velocity, double needed_m) const;

  GuardSettings settings_;
  BodyBox body_;
  double margin_m_;  // kept now
  double near_m_;    // further points cannot matter
  std::vector<Point> points_;
};

/// As `Guard::allowed`, of the first velocity that every guard allows.
[[nodiscard]] Velocity allowedByAll(std::initializer_list<const Guard*> guards, const Velocity& wanted);

}  // namespace underway
