#include "geometry/turning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace underway {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kStill_rad = 1e-12;  // a smaller turn moves nothing

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
Point scaled(Point a, double by) { return {a.x * by, a.y * by}; }
Point sum(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point difference(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
double norm(Point a) { return std::sqrt(dot(a, a)); }

/// A point of a segment, and how far it is from an arc.
struct Reach {
  double distance_m = kNone;
  Point on_segment;
  void consider(double distance, Point point) {
    if (distance < distance_m) *this = {distance, point};
  }
};

/// Corners in the plane, grown to all sides.
std::array<Point, 4> cornersOf(Range x, Range y) {
  return {Point{x.min, y.min}, Point{x.max, y.min}, Point{x.max, y.max}, Point{x.min, y.max}};
}

}  // namespace

/// The way of a point about the origin, counter-clockwise.
struct Turning::Arc {
  Point begin;
  Point end;
  double angle_rad;
  double radius_m;

  /// Whether a direction lies on the way; the length of `w` does not matter.
  [[nodiscard]] bool covers(Point w) const {
    if (angle_rad >= 2.0 * std::numbers::pi) return true;
    if (angle_rad <= std::numbers::pi) return cross(begin, w) >= 0.0 && cross(w, end) >= 0.0;
    return !(cross(end, w) > 0.0 && cross(w, begin) > 0.0);
  }

  /// Whether it crosses a segment, or passes an end of it within a contact's width.
  [[nodiscard]] bool crosses(Point a, Point b) const {
    bool does = false;
    visitCrossings(a, b, [&](Point at) { does |= covers(at); });
    return does;
  }

  /// Calls visit(point) where its circle crosses a segment, or passes an end of it within a contact's width.
  template <class Visit>
  void visitCrossings(Point a, Point b, const Visit& visit) const {
    const Point along = difference(b, a);
    const double length = norm(along);
    if (length == 0.0) return;  // a point: its own arc tells
    // The line's nearest point to the origin, from the height above it: squares of far corners would round.
    const Point direction = scaled(along, 1.0 / length);
    const double height = cross(a, direction);
    if (std::abs(height) > radius_m) return;
    const double half_chord = std::sqrt((radius_m - height) * (radius_m + height));
    const double foot_at = -dot(a, direction);
    const Point foot{height * direction.y, -height * direction.x};
    for (const double side : {-half_chord, half_chord}) {
      const double at = foot_at + side;
      if (at < -kContact_m || at > length + kContact_m) continue;
      visit(sum(foot, scaled(direction, side)));
    }
  }

  /// The nearest that it comes to a segment, if they do not cross.
  [[nodiscard]] Reach reach(Point a, Point b) const {
    Reach least;
    for (const Point tip : {begin, end}) {
      const Point nearest = nearestOnSegment(tip, a, b);
      least.consider(norm(difference(nearest, tip)), nearest);
    }
    for (const Point corner : {a, b})
      if (covers(corner)) least.consider(std::abs(norm(corner) - radius_m), corner);
    // Where a line outside the circle is nearest to it.
    const Point foot = nearestOnSegment({0.0, 0.0}, a, b);
    if (const double away = norm(foot); away >= radius_m && covers(foot))
      least.consider(away - radius_m, foot);
    return least;
  }
};

Turning::Turning(const Prism& body, double angle_rad)
    : body_(body),
      angle_rad_(std::min(std::abs(angle_rad), 2.0 * std::numbers::pi)),
      is_mirrored_(angle_rad < 0.0) {
  cos_ = std::cos(angle_rad_);
  sin_ = std::sin(angle_rad_);
  yaw_cos_ = std::cos(body.frame.yaw);
  yaw_sin_ = std::sin(body.frame.yaw);
  first_ = body.footprint();
  Prism turned = body;
  turned.frame.yaw += is_mirrored_ ? -angle_rad_ : angle_rad_;
  last_ = turned.footprint();
  local_ = cornersOf(body.x, is_mirrored_ ? Range{-body.y.max, -body.y.min} : body.y);
  outer_m_ = 0.0;
  for (const Point corner : local_) outer_m_ = std::max(outer_m_, norm(corner));
  inner_m_ = std::max(0.0, std::min({-body.x.min, body.x.max, -body.y.min, body.y.max}));
}

Point Turning::inBody(Point map) const {
  const double dx = map.x - body_.frame.x;
  const double dy = map.y - body_.frame.y;
  const double y = yaw_cos_ * dy - yaw_sin_ * dx;
  return {yaw_cos_ * dx + yaw_sin_ * dy, is_mirrored_ ? -y : y};
}

Turning::Arc Turning::arcFrom(Point begin) const {
  return {begin, {cos_ * begin.x - sin_ * begin.y, sin_ * begin.x + cos_ * begin.y}, angle_rad_, norm(begin)};
}

Turning::Arc Turning::arcTo(Point end) const {
  return {{cos_ * end.x + sin_ * end.y, cos_ * end.y - sin_ * end.x}, end, angle_rad_, norm(end)};
}

bool Turning::touches(ConvexView piece) const {
  if (angle_rad_ < kStill_rad) return areTouching(first_, piece);
  // A hair larger, from the beginning on: then a touch is a crossing, however it rounds.
  if (areTouching(body_.grown(kContact_m).footprint(), piece) || areTouching(last_, piece)) return true;
  const Range x{local_[0].x - kContact_m, local_[2].x + kContact_m};
  const Range y{local_[0].y - kContact_m, local_[2].y + kContact_m};
  const std::array<Point, 4> body = cornersOf(x, y);
  std::array<Arc, 4> ways{arcFrom(body[0]), arcFrom(body[1]), arcFrom(body[2]), arcFrom(body[3])};
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Point corner = inBody(piece[i]);
    const Point next = inBody(piece[(i + 1) % piece.size()]);
    for (const Arc& way : ways)
      if (way.crosses(corner, next)) return true;
    const Arc way = arcTo(corner);  // of the piece's corner, seen from the body
    if (way.radius_m > outer_m_ + 2.0 * kContact_m) continue;
    for (std::size_t k = 0; k < 4; ++k)
      if (way.crosses(body[k], body[(k + 1) % 4])) return true;
  }
  return false;
}

TurningRoom Turning::roomBeside(ConvexView piece) const {
  constexpr double kRevolution = 2.0 * std::numbers::pi;
  constexpr double kSlack_rad = 1e-7;  // above what contact and rounding make of an angle
  const std::array<Point, 4> body = cornersOf({local_[0].x - kContact_m, local_[2].x + kContact_m},
                                              {local_[0].y - kContact_m, local_[2].y + kContact_m});
  double first = kRevolution;  // contact counter-clockwise from the heading
  double last = 0.0;
  const auto meets = [&](Point from, Point to) {
    const double way = std::atan2(cross(from, to), dot(from, to));
    const double angle = way < 0.0 ? way + kRevolution : way;
    first = std::min(first, angle);
    last = std::max(last, angle);
  };
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Point corner = inBody(piece[i]);
    const Point next = inBody(piece[(i + 1) % piece.size()]);
    for (const Point begin : body)
      arcFrom(begin).visitCrossings(corner, next, [&](Point at) { meets(begin, at); });
    const Arc way = arcTo(corner);  // of the piece's corner, seen from the body
    if (way.radius_m > outer_m_ + 2.0 * kContact_m) continue;
    for (std::size_t k = 0; k < 4; ++k)
      way.visitCrossings(body[k], body[(k + 1) % 4], [&](Point at) { meets(at, corner); });
  }
  return {std::max(0.0, first - kSlack_rad), std::max(0.0, kRevolution - last - kSlack_rad)};
}

Gap Turning::gapTo(ConvexView piece) const {
  if (touches(piece)) return {0.0, piece.front()};
  const std::array<Arc, 4> ways{arcFrom(local_[0]), arcFrom(local_[1]), arcFrom(local_[2]),
                                arcFrom(local_[3])};
  Gap best{kNone, {}};
  const auto consider = [&](double distance_m, Point at) {
    if (distance_m < best.distance_m) best = {distance_m, at};
  };
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const std::size_t k = (i + 1) % piece.size();
    const Point corner = inBody(piece[i]);
    const Point next = inBody(piece[k]);
    for (const Arc& way : ways) {
      const Reach reach = way.reach(corner, next);
      if (!(reach.distance_m < best.distance_m)) continue;
      const Point edge = difference(next, corner);
      const double squared = dot(edge, edge);
      const double t = squared > 0.0 ? dot(difference(reach.on_segment, corner), edge) / squared : 0.0;
      consider(reach.distance_m,
               {piece[i].x + t * (piece[k].x - piece[i].x), piece[i].y + t * (piece[k].y - piece[i].y)});
    }
    const Arc way = arcTo(corner);
    for (std::size_t side = 0; side < 4; ++side)
      consider(way.reach(local_[side], local_[(side + 1) % 4]).distance_m, piece[i]);
  }
  return {told(best.distance_m), best.at};
}

}  // namespace underway
