#pragma once

#include <string>
#include <tl/expected.hpp>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/push.hpp"
#include "gait/joint_table.hpp"

namespace underway::gait {

/// The projected-profile crawl (Brooks 2017, 4.2; Brooks 2015, section IV). One cycle:
///
///   lying      on chest and hips, lower legs and arms off the floor
///   extension  M1: arms reach ahead, toes go down; toes and elbows make a closed chain
///   push       M2: the chain moves the body ahead, toes and elbows where they are
///   lowering   M3: the chest goes down, then knees and arms go up: lying again, one stroke further
///
/// Left and right are alike, unless the gait turns.

/// How the lying robot holds what is off the floor, and how it gets there.
struct LyingShape {
  double shoulder_height_m = 0.035;  ///< over the elbows, when M3 has lowered the chest
  double knee_rad = 1.05;            ///< bent, the feet up
  double arm_rise_rad = 0.0;         ///< alpha of the raised arms: level with the shoulders
  double arm_spread_m = 0.095;       ///< of the elbows, while they are raised and brought ahead
};

/// How long each part takes [s].
struct CrawlTimes {
  double extension_s = 0.8;
  double push_s = 1.0;
  double lowering_s = 1.4;
  [[nodiscard]] double cycle() const { return extension_s + push_s + lowering_s; }
  bool operator==(const CrawlTimes&) const = default;
};

struct CrawlGait {
  std::string name;
  PushShape push;
  double toe_to_elbow_m = 0.43;  ///< d_e, of the closed chain
  double spread_m = 0.0565;      ///< d: the elbows outside of the shoulders, in the push
  double turn_rad = 0.0;         ///< by each push, to the left
  CrawlTimes times;
  LyingShape lying;
};

/// Why a gait cannot be walked by a robot: one sentence (what, where, what to do).
struct GaitError {
  std::string message;
};
template <class T>
using GaitExpected = tl::expected<T, GaitError>;

/// The author's own gait for NAO: Table 8, d_e 430 mm, l5 89.75 mm.
[[nodiscard]] CrawlGait nominalGait();

/// Joint angles of `cycles` cycles, from lying to lying, in rows at most 20 ms apart. Errors: the push is
/// infeasible, or a joint would leave its limits or be faster than it can: which, where, by how much.
[[nodiscard]] GaitExpected<JointTable> crawlMotion(const Crawler& crawler, const CrawlGait& gait, int cycles);

}  // namespace underway::gait
