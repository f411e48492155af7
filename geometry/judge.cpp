#include "geometry/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/turning_points.hpp"

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

TurningPoints cornersOf(const Prism& body) { return {body.footprint(), body.frame.position()}; }

TurningPoints cornersOf(const OrientedBox& box, Point pivot) {
  std::array<Point, 8> points;
  const auto vertices = corners(box);
  std::transform(vertices.begin(), vertices.end(), points.begin(), [](const Vec3& vertex) {
    return Point{vertex.x, vertex.y};
  });
  return {points, pivot};
}

Range heightsOf(const OrientedBox& box) {
  const auto vertices = corners(box);
  const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(),
                                               [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  return {low->z, high->z};
}

/// Where an obstacle is nearest to a point, as seen from there [rad]; of tilted ones, about.
double bearingOf(const OrientedBox& box, Point from) {
  const double c = std::cos(box.rpy_rad.z);
  const double s = std::sin(box.rpy_rad.z);
  const Point off{from.x - box.center_m.x, from.y - box.center_m.y};
  const double x = std::clamp(c * off.x + s * off.y, -0.5 * box.size_m.x, 0.5 * box.size_m.x);
  const double y = std::clamp(c * off.y - s * off.x, -0.5 * box.size_m.y, 0.5 * box.size_m.y);
  return std::atan2(s * x + c * y - off.y, c * x - s * y - off.x);
}

/// A body that turns beside an obstacle. What it covers over an interval of the turn lies in a box of any
/// heading, and is clear of the obstacle if one such box is. Tried are headings along the obstacle's faces,
/// for a corner of the body that passes a face; along the body's own, seen from where it is the obstacle that
/// turns; across the line of sight, for a corner that passes a corner; and the body's in the middle of the
/// interval, which comes to the truth as intervals shrink. If none is clear, the interval is halved.
class TurnPast {
 public:
  TurnPast(const Prism& body, const FclShapes& shapes, std::size_t i, double clearance_m)
      : body_(body),
        body_corners_(cornersOf(body)),
        shapes_(shapes),
        i_(i),
        faces_yaw_(shapes.box(i).rpy_rad.z),
        bearing_(bearingOf(shapes.box(i), body.frame.position())),
        corners_(cornersOf(shapes.box(i), body.frame.position())),
        heights_(heightsOf(shapes.box(i))),
        clearance_m_(clearance_m) {}

  /// Over angles from the body's heading [rad], to the accuracy of kTurnSlack_m.
  [[nodiscard]] bool isClear(Range angles) const {
    const double middle = 0.5 * (angles.min + angles.max);
    if (isBoxClear(angles, faces_yaw_) || isObstacleClear(angles) || isBoxClear(angles, bearing_) ||
        isBoxClear(angles, body_.frame.yaw + middle))
      return true;
    if (body_corners_.reach() * angles.length() <= kTurnSlack_m) return false;
    return isClear({angles.min, middle}) && isClear({middle, angles.max});
  }

 private:
  [[nodiscard]] bool isBoxClear(Range angles, double yaw) const {
    return !shapes_.comesWithin(i_, body_corners_.boxAround(angles, yaw, body_.z), clearance_m_);
  }
  [[nodiscard]] bool isObstacleClear(Range angles) const {
    const Range back{-angles.max, -angles.min};
    return !comeWithin(corners_.boxAround(back, body_.frame.yaw, heights_), body_, clearance_m_);
  }

  const Prism& body_;  // where the turn begins
  TurningPoints body_corners_;
  const FclShapes& shapes_;
  std::size_t i_;
  double faces_yaw_;
  double bearing_;
  TurningPoints corners_;
  Range heights_;
  double clearance_m_;
};

bool isTurnClear(const Prism& body, Range angles, const FclShapes& shapes, double clearance_m) {
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (!TurnPast(body, shapes, i, clearance_m).isClear(angles)) return false;
  return true;
}

}  // namespace

bool Judge::isClear(const Motion& motion, double clearance_m) const {
  const Prism body = sweptBox(robot_, motion, world_.floorZ());
  if (motion.kind != MotionKind::kTurn || motion.angle_rad == 0.0)
    return !scene_.shapesIn(regionOf(body, clearance_m)).comeWithin(body, clearance_m - kSlack_m);
  const Point pivot = motion.from.position();
  const double reach_m = reachOf(robot_.modes[motion.mode].body_m) + std::max(clearance_m, 0.0);
  const double angle = sweptAngle(motion);
  return isTurnClear(body, {std::min(angle, 0.0), std::max(angle, 0.0)},
                     scene_.shapesIn(Region::between(pivot, pivot).grown(reach_m)),
                     clearance_m - kTurnSlack_m);
}

}  // namespace underway
