#include "geometry/headroom.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
/// than reach times half the angle, so the grown body at the middle covers them all.
class TurningLowest {
 public:
  TurningLowest(const OrientedBox& box, const Prism& body, double reach_m)
      : box_(box), body_(body), reach_m_(reach_m) {}

  void search(double middle_rad, double half_rad) {
    const double moved = reach_m_ * half_rad;
    const auto bound = at(middle_rad, moved);
    if (!bound || (lowest_.height() && *bound >= *lowest_.height())) return;
    lowest_.include(at(middle_rad, 0.0));
    if (moved < kFinest_m) return lowest_.include(bound);
    search(middle_rad - 0.5 * half_rad, 0.5 * half_rad);
    search(middle_rad + 0.5 * half_rad, 0.5 * half_rad);
  }

  [[nodiscard]] const std::optional<double>& height() const { return lowest_.height(); }

 private:
  [[nodiscard]] std::optional<double> at(double turned_rad, double moved_m) const {
    Prism body = body_.grown(moved_m);
    body.frame.yaw += turned_rad;
    return lowestAbove(box_, body.footprint(), body.z.max);
  }

  const OrientedBox& box_;
  const Prism& body_;
  double reach_m_;
  Lowest lowest_;
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
      TurningLowest search(box, body, turning.outerRadius());
      search.search(0.5 * angle, 0.5 * std::abs(angle));
      lowest.include(search.height());
    }
    return false;
  });
  return lowest.above(body.z.max);
}

}  // namespace underway
