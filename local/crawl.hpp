#pragma once

#include <cstddef>
#include <optional>

#include "geometry/checker.hpp"
#include "planner/plan.hpp"

namespace underway {

/// The papers' own trigger (Brooks 2015, Fig. 7; Brooks 2017, chapter 5): closer than a threshold to the low
/// obstacle it goes down as it stands, crawls a set number of cycles, and gets up where it is then. Neither
/// number is in the papers: the threshold is what NAO's way down reaches ahead and 5 cm, the cycles bring it
/// under a table.
struct PapersTrigger {
  double threshold_m = 0.6;  ///< from the standing body to what it does not fit under, straight ahead [m]
  int cycles = 25;
};

struct CrawlSettings {
  double stroke_m = 0.0777;             ///< of a cycle that does not slip (Brooks 2017, chapter 4) [m]
  double kept = 0.87;                   ///< the share of it that the real robot kept (610 mm in 9 cycles)
  double kept_sigma = 0.05;             ///< of each cycle's share
  bool keeps_heading = false;           ///< steers against the drift of its heading by itself
  double fix_sigma_m = 0.01;            ///< of its position when it goes down [m]
  double sigmas = 3.0;                  ///< how sure it is of room before it gets up
  double longest_extra_m = 0.6;         ///< how far beyond the planned end it looks for room to get up [m]
  double stall_s = 10.0;                ///< a cycle that takes longer does not progress [s]
  int aligned_ticks = 10;               ///< in a row, before it goes down
  std::optional<PapersTrigger> papers;  ///< instead of all that; to compare with
};

/// A plan's low passage: from the switch down to the switch up, or to the end of the plan.
struct Passage {
  std::size_t down = 0;        ///< segment of the switch down
  double length_m = 0.0;       ///< crawled
  double slack_m = 0.0;        ///< least clearance from going down to having got up [m]
  double tolerance_m = 0.0;    ///< of the position to go down at, across the passage [m]
  double tolerance_rad = 0.0;  ///< of the heading
};
/// The passage that begins with a segment; `down` is that segment.
[[nodiscard]] Passage passageFrom(const Plan& plan, const Robot& robot, std::size_t down);

/// The pose to go down at: the planned one, turned against half of the drift that the crawl will make, so
/// that it comes out where it was planned. As the turned body reaches further ahead, it is a little further
/// back where the way down is tight, or turned less.
[[nodiscard]] Pose entryOf(const Passage& passage, const Plan& plan, double drift_rad_per_m,
                           const Checker& checker);

/// Whether the standing body is free where the crawling robot may be: `at`, further back and further on by
/// `unsure_m`, as the map says.
[[nodiscard]] bool hasRoomUp(const Checker& checker, const Switch& up, const Pose& at, double unsure_m);

/// Whether something is closer than so much straight ahead of a standing body, by the map, under which the
/// robot fits in a lower mode.
[[nodiscard]] bool isNearLow(const Checker& checker, ModeId standing, ModeId low, const Pose& at,
                             double nearer_m);

/// How unsure it is of its place along the passage after some whole strokes, as a standard deviation [m].
/// What each has lost is one for itself: of a share of a stroke its square counts.
[[nodiscard]] double sigmaAfter(double strokes, const CrawlSettings& settings);

}  // namespace underway
