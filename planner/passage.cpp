#include "planner/passage.hpp"

#include <cmath>
#include <numbers>

namespace underway {
namespace {

/// Writes a route motion by motion, always from where and how the robot is.
class Writer {
 public:
  explicit Writer(const Stance& stance) : here_(stance) {}

  [[nodiscard]] Stance here() const { return here_; }
  bool change(const Legs& legs, Point at, const Stance& to, double keep_m) {
    const auto change = legs.change(at, here_, to, keep_m);
    if (!change) return false;
    route_.insert(route_.end(), change->begin(), change->end());
    here_.mode = to.mode;
    if (std::abs(normalizedAngle(to.yaw - here_.yaw)) > Legs::kSameYaw_rad) here_.yaw = to.yaw;
    return true;
  }
  /// A heading that is right but for rounding becomes right bit for bit.
  void turnExactly(Point at, double yaw) {
    if (here_.yaw == yaw) return;
    route_.push_back(turn(here_.mode, {at.x, at.y, here_.yaw}, normalizedAngle(yaw - here_.yaw), yaw));
    here_.yaw = yaw;
  }
  void leg(const Way& way, Point from, Point to) {
    route_.push_back(translate(way.mode, way.sense, {from.x, from.y, here_.yaw}, to));
  }
  void append(const Option& option) {
    route_.insert(route_.end(), option.motions.begin(), option.motions.end());
    if (!option.motions.empty()) here_ = {option.out.yaw, option.out_mode};
  }
  [[nodiscard]] const Route& route() const { return route_; }

 private:
  Stance here_;
  Route route_;
};

/// Where the line through a point along a heading comes closest to another.
Point ahead(Point from, double heading_rad, Point to) {
  const Point axis{std::cos(heading_rad), std::sin(heading_rad)};
  const double way = (to.x - from.x) * axis.x + (to.y - from.y) * axis.y;
  return {from.x + way * axis.x, from.y + way * axis.y};
}

}  // namespace

Option Option::stop(Point at, double keep_m) {
  const Pose pose{at.x, at.y, 0.0};
  return {pose, pose, 0, 0, true, true, keep_m, {}, {}};
}

std::vector<Point> stopsBetween(const std::vector<Passage::Step>& steps, std::size_t i) {
  const Passage::Step& a = steps[i - 1];
  const Passage::Step& b = steps[i];
  const Point from = a.option.out.position();
  const Point to = b.option.in.position();
  std::vector<Point> points;
  points.reserve(4);
  const double before = i >= 2 && a.way ? a.arriving.yaw : a.leaving.yaw;
  const bool goes_on = i + 1 < steps.size() && steps[i + 1].way;
  const double after = goes_on ? steps[i + 1].arriving.yaw : b.option.in.yaw;
  for (const double quarter : {0.0, 0.5 * std::numbers::pi}) {
    points.push_back(ahead(from, before + quarter, to));
    if (!b.option.any_heading || b.option.is_stop) points.push_back(ahead(to, after + quarter, from));
  }
  return points;
}

bool isAside(Policy policy, const Passage::Step& step) {
  return policy == Policy::kPriority && step.way && step.legs->ways()[*step.way].mode != 0;
}

Route routeOf(const Passage& passage) {
  Writer writer(passage.steps.front().leaving);
  for (std::size_t i = 1; i < passage.steps.size(); ++i) {
    const Passage::Step& step = passage.steps[i];
    const Option& before = passage.steps[i - 1].option;
    const Option& here = step.option;
    if (step.way) {
      Stance on_leg = step.arriving;
      const bool keeps_yaw = std::abs(normalizedAngle(on_leg.yaw - writer.here().yaw)) <= Legs::kSameYaw_rad;
      const bool meets_yaw = !here.is_stop && !here.any_heading &&
                             std::abs(normalizedAngle(on_leg.yaw - here.in.yaw)) <= Legs::kSameYaw_rad;
      if (!keeps_yaw && meets_yaw) on_leg.yaw = here.in.yaw;
      if (!writer.change(*step.legs, before.out.position(), on_leg, before.keep_m)) return {};
      writer.leg(step.legs->ways()[*step.way], before.out.position(), here.in.position());
    }
    if (here.is_stop) continue;
    const Stance needed{here.any_heading ? writer.here().yaw : here.in.yaw, here.in_mode};
    if (!writer.change(*step.legs, here.in.position(), needed, here.keep_m)) return {};
    writer.turnExactly(here.in.position(), needed.yaw);
    writer.append(here);
  }
  return writer.route();
}

}  // namespace underway
