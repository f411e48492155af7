#include "geometry/headroom.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "geometry/flatten.hpp"

namespace underway {
namespace {

constexpr double kFinest_m = 5e-4;  // to which the way of a turning body is halved

/// The lowest of many heights.
class Lowest {
 public:
  void include(std::optional<double> height) {
    if (height) lowest_ = std::min(lowest_.value_or(*height), *height);
  }
  [[nodiscard]] const std::optional<double>& height() const { return lowest_; }
  [[nodiscard]] std::optional<double> above(double top) const {
    return lowest_ ? std::optional(*lowest_ - top) : std::nullopt;
  }

 private:
  std::optional<double> lowest_;
};

double undersideOf(const OrientedBox& upright) { return upright.center_m.z - 0.5 * upright.size_m.z; }

/// Branch and bound over the headings of a turn: within half an interval no point of the body moves further
/// than reach times half the angle, so the grown body at the middle covers them all. The interval that may be
/// lowest comes first: below a steep box the others are many.
class TurningLowest {
 public:
  TurningLowest(const OrientedBox& box, const Prism& body, double reach_m)
      : box_(box), body_(body), reach_m_(reach_m) {}

  [[nodiscard]] std::optional<double> over(double angle_rad) {
    Lowest lowest;
    open(0.5 * angle_rad, 0.5 * std::abs(angle_rad));
    while (!open_.empty()) {
      const Interval here = open_.top();
      open_.pop();
      if (lowest.height() && here.bound_m >= *lowest.height()) break;
      if (reach_m_ * here.half_rad < kFinest_m) {
        lowest.include(here.bound_m);
        break;
      }
      lowest.include(at(here.middle_rad, 0.0));
      open(here.middle_rad - 0.5 * here.half_rad, 0.5 * here.half_rad);
      open(here.middle_rad + 0.5 * here.half_rad, 0.5 * here.half_rad);
    }
    return lowest.height();
  }

 private:
  struct Interval {
    double bound_m;  // no heading in it meets anything lower
    double middle_rad;
    double half_rad;
    bool operator<(const Interval& other) const { return bound_m > other.bound_m; }
  };

  void open(double middle_rad, double half_rad) {
    if (const auto bound = at(middle_rad, reach_m_ * half_rad)) open_.push({*bound, middle_rad, half_rad});
  }

  [[nodiscard]] std::optional<double> at(double turned_rad, double moved_m) const {
    Prism body = body_.grown(moved_m);
    body.frame.yaw += turned_rad;
    return lowestAbove(box_, body.footprint(), body.z.max);
  }

  const OrientedBox& box_;
  const Prism& body_;
  double reach_m_;
  std::priority_queue<Interval> open_;
};

}  // namespace

std::optional<double> headroomBelow(const Layer& hanging, const Prism& body) {
  Lowest lowest;
  hanging.visitTouched(body, [&](const Piece& piece) {
    const OrientedBox& box = piece.obstacle->box;
    lowest.include(isUpright(box) ? undersideOf(box) : lowestAbove(box, body.footprint(), body.z.max));
    return false;
  });
  return lowest.above(body.z.max);
}

std::optional<double> headroomBelow(const Layer& hanging, const Prism& body, double angle_rad) {
  const Turning turning(body, angle_rad);
  constexpr double kRevolution = 2.0 * std::numbers::pi;  // all headings, from there on
  const double angle = std::clamp(angle_rad, -kRevolution, kRevolution);
  Lowest lowest;
  hanging.visitTouched(turning, [&](const Piece& piece) {
    const OrientedBox& box = piece.obstacle->box;
    if (isUpright(box)) {
      lowest.include(undersideOf(box));
    } else {
      lowest.include(TurningLowest(box, body, turning.outerRadius()).over(angle));
    }
    return false;
  });
  return lowest.above(body.z.max);
}

}  // namespace underway
