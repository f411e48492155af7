#include "geometry/judge.hpp"

#include <algorithm>

namespace underway {
namespace {

constexpr double kSlack_m = 1e-6;      // a claim may equal the truth: ask for this much less
constexpr double kTurnSlack_m = 1e-4;  // how finely a turn is judged

/// What a motion may come near, by a clearance.
Region regionOf(const Prism& box, double clearance_m) {
  const auto footprint = box.footprint();
  Region region = Region::between(footprint[0], footprint[2]);
  return region.joint(Region::between(footprint[1], footprint[3])).grown(std::max(clearance_m, 0.0));
}

}  // namespace

bool Judge::isClear(const Motion& motion, double clearance_m) const {
  Prism body = sweptBox(robot_, motion, world_.floorZ());
  if (motion.kind != MotionKind::kTurn || motion.angle_rad == 0.0)
    return !scene_.shapesIn(regionOf(body, clearance_m)).comeWithin(body, clearance_m - kSlack_m);
  // Conservative advancement by halves: what the body reaches within half an interval is the body at its
  // middle, grown by reach times half the angle.
  const double reach = reachOf(robot_.modes[motion.mode].body_m);
  const Point pivot = motion.from.position();
  const double half_turn = 0.5 * std::abs(sweptAngle(motion));
  const Region region = Region::between(pivot, pivot).grown(reach + clearance_m + reach * half_turn);
  const FclShapes shapes = scene_.shapesIn(region);
  const auto is_clear = [&](const auto& self, double middle, double half) -> bool {
    body.frame.yaw = motion.from.yaw + middle;
    const double moved = reach * half;
    if (!shapes.comeWithin(body, clearance_m - kTurnSlack_m + moved)) return true;
    if (2.0 * moved <= kTurnSlack_m) return false;
    return self(self, middle - 0.5 * half, 0.5 * half) && self(self, middle + 0.5 * half, 0.5 * half);
  };
  return is_clear(is_clear, 0.5 * sweptAngle(motion), half_turn);
}

}  // namespace underway
