#pragma once

#include <array>

#include "gait/crawl/crawler.hpp"
#include "gait/crawl/gait.hpp"

namespace underway::gait {

/// The whole robot at one instant of a crawl.
struct Posture {
  std::array<SideShape, 2> sides;  ///< left, right
  double head_rad = 0.0;           ///< pitch, towards the chest
};

/// Every number on its way from one posture to another: share 0 is `from`, 1 is `to`.
[[nodiscard]] Posture between(const Posture& from, const Posture& to, double share);

/// In the push, at a phase 0..1. Where the gait turns, each side makes up for how far the turning body
/// carries its hip and shoulder ahead or back. Infeasible where the chain is.
[[nodiscard]] Feasible<Posture> pushPosture(const Crawler& crawler, const CrawlGait& gait, double phase);

/// Toes and elbows where the push left them, the shoulders lower: 0 as high as the push ended, 1 at
/// LyingShape::shoulder_height_m, the hips as they lie. The elbows make way to the sides.
[[nodiscard]] Feasible<Posture> spreadPosture(const Crawler& crawler, const CrawlGait& gait, double share);

/// Lying before the push, arms and feet off the floor.
[[nodiscard]] Feasible<Posture> lyingPosture(const Crawler& crawler, const CrawlGait& gait);

}  // namespace underway::gait
