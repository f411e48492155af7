#include "local/guard.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/sweep.hpp"

namespace underway {
namespace {

/// From a body to a point; negative inside the body. What is further than `most_m` is told as that: most
/// points are, and are known to be before a root is drawn.
double distanceTo(const BodyBox& body, Point p, double most_m) {
  const double dx = std::max(body.x.min - p.x, p.x - body.x.max);
  const double dy = std::max(body.y.min - p.y, p.y - body.y.max);
  const double further = std::max(dx, dy);
  if (further >= most_m) return most_m;
  return dx > 0.0 && dy > 0.0 ? std::min(std::sqrt(dx * dx + dy * dy), most_m) : further;
}

/// Where a point is, seen from a body that has moved.
class Moved {
 public:
  Moved(const Velocity& velocity, double time_s)
      : x_(velocity.x_mps * time_s),
        y_(velocity.y_mps * time_s),
        cos_(std::cos(velocity.turn_radps * time_s)),
        sin_(std::sin(velocity.turn_radps * time_s)) {}
  Point operator()(Point p) const {
    const double x = p.x - x_;
    const double y = p.y - y_;
    return {cos_ * x + sin_ * y, cos_ * y - sin_ * x};
  }

 private:
  double x_;
  double y_;
  double cos_;
  double sin_;
};

constexpr double kSlack_m = 1e-4;

}  // namespace

Guard::Guard(const GuardSettings& settings, const BodyBox& body, std::size_t most_points)
    : settings_(settings),
      body_(body),
      margin_m_(settings.margin_m),
      near_m_(reachOf(body) + settings.margin_m + settings.horizon_s * settings.fastest_mps) {
  points_.reserve(most_points);
}

void Guard::look(const Scan& scan) {
  forEachBeam(scan.beams, 0.0, [&](std::size_t i, Point direction) {
    const double range = scan.ranges_m[i];
    if (range <= near_m_) add({range * direction.x, range * direction.y});
  });
}

void Guard::add(Point point) {
  const bool is_near = point.x * point.x + point.y * point.y <= near_m_ * near_m_;
  if (is_near && points_.size() < points_.capacity()) points_.push_back(point);
}

double Guard::distanceAfter(const Velocity& velocity, double time_s) const {
  return distanceAfter(velocity, time_s, near_m_);
}

double Guard::distanceAfter(const Velocity& velocity, double time_s, double most_m) const {
  const Moved moved(velocity, time_s);
  double nearest = most_m;
  for (const Point p : points_) nearest = std::min(nearest, distanceTo(body_, moved(p), nearest));
  return nearest;
}

Velocity Guard::allowed(const Velocity& wanted) const { return allowedByAll({this}, wanted); }

bool Guard::allows(const Velocity& velocity) const {
  if (points_.empty()) return true;
  const double nearest = distanceAfter({}, 0.0, margin_m_ + kSlack_m) - kSlack_m;
  return !bringsNearer(velocity, std::max(nearest, std::min(settings_.least_m, margin_m_)));
}

/// At the horizon, and half way there: a corner may swing past a point and away again.
bool Guard::bringsNearer(const Velocity& velocity, double needed_m) const {
  const Moved half_way(velocity, 0.5 * settings_.horizon_s);
  const Moved moved(velocity, settings_.horizon_s);
  return std::any_of(points_.begin(), points_.end(), [&](Point p) {
    const double after =
        std::min(distanceTo(body_, half_way(p), needed_m), distanceTo(body_, moved(p), needed_m));
    return after < needed_m && after < distanceTo(body_, p, needed_m) - kSlack_m;
  });
}

Velocity allowedByAll(std::initializer_list<const Guard*> guards, const Velocity& wanted) {
  const auto scaled = [&](double way, double turn) {
    return Velocity{way * wanted.x_mps, way * wanted.y_mps, turn * wanted.turn_radps};
  };
  for (const Velocity& candidate : {scaled(1.0, 1.0), scaled(0.5, 1.0), scaled(0.5, 0.5), scaled(0.2, 0.2),
                                    scaled(0.0, 1.0), scaled(0.0, 0.3), scaled(0.3, 0.0)})
    if (std::all_of(guards.begin(), guards.end(),
                    [&](const Guard* guard) { return guard->allows(candidate); }))
      return candidate;
  return {};
}

Velocity Guard::retreat(double speed_mps) const {
  Point nearest{0.0, 0.0};
  double least = near_m_;
  for (const Point p : points_)
    if (const double d = distanceTo(body_, p, least); d < least) least = d, nearest = p;
  const double range = std::hypot(nearest.x, nearest.y);
  if (range == 0.0) return {};
  return {-speed_mps * nearest.x / range, -speed_mps * nearest.y / range, 0.0};
}

}  // namespace underway
