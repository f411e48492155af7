#include "geometry/judge.hpp"

#include <algorithm>

namespace underway {
namespace {

constexpr double kSlack_m = 1e-6;      // a claim may equal the truth: ask for this much less
constexpr double kTurnSlack_m = 1e-4;  // how finely a turn is judged

}  // namespace

bool Judge::isClear(const Prism& box, double clearance_m) const {
  // All points within the clearance of a box: the box grown along either axis, and a cylinder round each
  // edge.
  if (clearance_m <= 0.0) return !scene_.touches(box);
  const Prism along_x{box.frame, box.x.grown(clearance_m), box.y, box.z};
  const Prism along_y{box.frame, box.x, box.y.grown(clearance_m), box.z};
  if (scene_.touches(along_x) || scene_.touches(along_y)) return false;
  const auto footprint = box.footprint();
  return std::none_of(footprint.begin(), footprint.end(),
                      [&](Point corner) { return scene_.touches(corner, clearance_m, box.z); });
}

bool Judge::isClear(const Motion& motion, double clearance_m) const {
  Prism body = sweptBox(robot_, motion, world_.floorZ());
  if (motion.kind != MotionKind::kTurn || motion.angle_rad == 0.0)
    return isClear(body, clearance_m - kSlack_m);
  // Conservative advancement by halves: what the body reaches within half an interval is the body at its
  // middle, grown by reach times half the angle.
  const double reach = reachOf(robot_.modes[motion.mode].body_m);
  const auto is_clear = [&](const auto& self, double middle, double half) -> bool {
    body.frame.yaw = motion.from.yaw + middle;
    const double moved = reach * half;
    if (isClear(body, clearance_m - kTurnSlack_m + moved)) return true;
    if (2.0 * moved <= kTurnSlack_m) return false;
    return self(self, middle - 0.5 * half, 0.5 * half) && self(self, middle + 0.5 * half, 0.5 * half);
  };
  return is_clear(is_clear, 0.5 * sweptAngle(motion), 0.5 * std::abs(sweptAngle(motion)));
}

}  // namespace underway
