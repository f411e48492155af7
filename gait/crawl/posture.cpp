#include "gait/crawl/posture.hpp"

#include <cmath>
#include <numbers>

namespace underway::gait {
namespace {

constexpr double kQuarter_rad = 0.5 * std::numbers::pi;

/// The head keeps the slope it has when the robot lies.
double headOver(const CrawlGait& gait, double back_rad) {
  return gait.lying.head_rad + back_rad - gait.lying.back_rad;
}

/// A side whose hip and shoulder are that far ahead of the chain's, toe and elbow where they were.
Feasible<SideShape> shifted(const Crawler& crawler, const ChainAngles& chain, const LinkLengths& lengths,
                            PlanePoint elbow, double hip_ahead_m, double shoulder_ahead_m) {
  const ChainPoints points = pointsOf(lengths, chain);
  const PlanePoint hip = points[3] + PlanePoint{hip_ahead_m, 0.0};
  const PlanePoint arm = elbow - (points[4] + PlanePoint{shoulder_ahead_m, 0.0});
  if (length(arm) > crawler.arm.humerus())
    return tl::unexpected(Infeasible{length(arm), 0.0, crawler.arm.humerus()});
  // Toe to hip alone: a chain without back and arm.
  const auto leg = pushPose({lengths[0], lengths[1], lengths[2], 0.0, 0.0}, {chain.knee(), 0.0, 0.0}, hip);
  if (!leg) return tl::unexpected(leg.error());
  const double thigh = leg->toe() + leg->ankle() + leg->knee();
  return SideShape{leg->ankle(),
                   leg->knee(),
                   chain.back() - thigh,
                   chain.back(),
                   std::atan2(arm.z, arm.x),
                   crawler.arm.spreadFor(length(arm)),
                   0.0};
}

/// Both sides of a chain on a body that is turned by `turn_rad` to the left.
Feasible<Posture> turned(const Crawler& crawler, const CrawlGait& gait, const ChainAngles& chain,
                         const LinkLengths& lengths, PlanePoint elbow, double turn_rad) {
  Posture posture;
  posture.head_rad = headOver(gait, chain.back());
  for (std::size_t side = 0; side < 2; ++side) {
    const double ahead = side == 0 ? -turn_rad : turn_rad;  // the right side goes ahead
    if (side == 1 && turn_rad == 0.0) {
      posture.sides[1] = posture.sides[0];
      continue;
    }
    const auto shape = shifted(crawler, chain, lengths, elbow, ahead * crawler.hip_half_width_m,
                               ahead * crawler.shoulder_half_width_m);
    if (!shape) return tl::unexpected(shape.error());
    posture.sides[side] = *shape;
  }
  return posture;
}

double mix(double from, double to, double share) { return from + share * (to - from); }

SideShape mix(const SideShape& a, const SideShape& b, double share) {
  return {mix(a.ankle, b.ankle, share), mix(a.knee, b.knee, share),   mix(a.hip, b.hip, share),
          mix(a.back, b.back, share),   mix(a.alpha, b.alpha, share), mix(a.spread_m, b.spread_m, share),
          mix(a.rise, b.rise, share)};
}

}  // namespace

Posture between(const Posture& from, const Posture& to, double share) {
  return {{mix(from.sides[0], to.sides[0], share), mix(from.sides[1], to.sides[1], share)},
          mix(from.head_rad, to.head_rad, share)};
}

Feasible<Posture> pushPosture(const Crawler& crawler, const CrawlGait& gait, double phase) {
  const LinkLengths lengths = crawler.lengths(gait.spread_m);
  const PlanePoint elbow{gait.toe_to_elbow_m, 0.0};
  const auto chain = pushPose(lengths, gait.push.at(phase), elbow);
  if (!chain) return tl::unexpected(chain.error());
  if (gait.turn_rad != 0.0)
    return turned(crawler, gait, *chain, lengths, elbow, (phase - 0.5) * gait.turn_rad);
  const SideShape shape = shapeOf(*chain, gait.spread_m);
  return Posture{{shape, shape}, headOver(gait, chain->back())};
}

Feasible<Posture> spreadPosture(const Crawler& crawler, const CrawlGait& gait, double share) {
  LinkLengths lengths = crawler.lengths(gait.spread_m);
  const Triplet end = gait.push.at(gait.stroke);
  const PlanePoint arm = along(lengths[4], end.alpha);
  const PlanePoint elbow{gait.toe_to_elbow_m, 0.0};
  // The shoulder straight down: the chain of a vertical arm that gets shorter.
  lengths[4] = mix(-arm.z, gait.lying.shoulder_height_m, share);
  const auto chain = pushPose(lengths, {end.knee, mix(end.hip, gait.lying.hip_rad, share), -kQuarter_rad},
                              {elbow.x - arm.x, 0.0});
  if (!chain) return tl::unexpected(chain.error());
  return turned(crawler, gait, *chain, lengths, elbow, (gait.stroke - 0.5) * gait.turn_rad);
}

Feasible<Posture> lyingPosture(const Crawler& crawler, const CrawlGait& gait) {
  auto posture = pushPosture(crawler, gait, 0.0);
  if (!posture) return posture;
  for (SideShape& side : posture->sides) {
    side.knee = gait.lying.knee_rad;
    side.hip = gait.lying.hip_rad;
    side.back = gait.lying.back_rad;
    if (gait.lying.lowering == Lowering::kSpread) side.alpha = gait.lying.arm_rise_rad;
  }
  posture->head_rad = gait.lying.head_rad;
  return posture;
}

}  // namespace underway::gait
