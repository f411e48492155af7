#pragma once

#include <string>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/push.hpp"
#include "gait/error.hpp"
#include "gait/joint_table.hpp"

namespace underway::gait {

/// The projected-profile crawl (Brooks 2017, 4.2; Brooks 2015, section IV). One cycle:
///
///   lying      on the chest, lower legs and arms off the floor
///   extension  M1: arms reach ahead, toes go down; toes and elbows make a closed chain
///   push       M2: the chain moves the body ahead, toes and elbows stay where they are
///   lowering   M3: the chest goes down, then knees and arms go up: lying again, one stroke further
///
/// Left and right are alike, unless the gait turns.

/// How M3 brings the chest down. What follows is the same: arms ahead, knees bent, the feet off the floor.
enum class Lowering {
  /// The elbows slide outwards until the chest lies, then the arms come ahead off the floor. Nothing slides
  /// along the way, so that the advance hardly knows the floor's friction; the elbows need room at the sides.
  kSpread,
  /// Hips first, then the elbows slide ahead. As narrow as the push; the floor's friction has its share in
  /// it.
  kSlide,
};

/// The robot lying, and its way there.
struct LyingShape {
  Lowering lowering = Lowering::kSpread;
  double shoulder_height_m = 0.03;  ///< spread: over the elbows, when the chest should lie
  double knee_rad = radians(22.0);  ///< bent, so that the feet are up
  double hip_rad = radians(20.0);
  double back_rad = radians(3.0);  ///< the chest's own slope on the floor
  double arm_rise_rad = 0.0;       ///< spread: alpha of the raised arms
  double head_rad = 0.0;           ///< the head's pitch, towards the chest; it keeps its slope in the push
};

/// How long each part takes [s].
struct CrawlTimes {
  double extension_s = 0.8;
  double push_s = 1.0;
  double lowering_s = 1.5;
  [[nodiscard]] double cycle() const { return extension_s + push_s + lowering_s; }
  bool operator==(const CrawlTimes&) const = default;
};

/// Everything that tells one crawl from another.
struct CrawlGait {
  std::string name;
  PushShape push;
  double toe_to_elbow_m = 0.43;  ///< d_e, of the closed chain
  double spread_m = 0.0565;      ///< d: the elbows outside of the shoulders, in the push
  double stroke = 1.0;           ///< the share of the push that is done, above 0: a shorter cycle
  double turn_rad = 0.0;         ///< of the body over its planted toes and elbows, in each push, to the left
  CrawlTimes times;
  LyingShape lying;
};

/// The author's own for NAO: Table 8, d_e 430 mm, l5 89.75 mm. The hips drag in the first half of the push.
[[nodiscard]] CrawlGait nominalGait();

/// For going far: hips at 20 degrees do not drag on the floor, and come down to it at the end of the push, so
/// that the body lies firmly while the elbows slide outwards. In physics it advances 88 to 92 mm a cycle,
/// keeps its heading better than the nominal one, and its joints leave room to steer.
[[nodiscard]] CrawlGait cruiseGait();

/// The joint angles of some cycles, from lying to lying, in rows at most 25 ms apart; as a motion it may
/// follow itself. Errors: a pose that the robot's lengths do not reach, a joint beyond its limits or faster
/// than it can: which, when, by how much. Throws std::invalid_argument unless there is at least one cycle.
[[nodiscard]] GaitExpected<JointTable> crawlMotion(const Crawler& crawler, const CrawlGait& gait,
                                                   int cycles = 1);

}  // namespace underway::gait
