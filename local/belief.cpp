#include "local/belief.hpp"

#include <algorithm>
#include <cmath>

namespace underway {
namespace {

constexpr int kFirst = 30;           // headings, before drift can be told from them
constexpr double kMostDrift = 0.15;  // [rad/m]

/// The part of a vector that lies across a direction.
Point across(Point vector, double direction_rad) {
  const Point left{-std::sin(direction_rad), std::cos(direction_rad)};
  const double size = vector.x * left.x + vector.y * left.y;
  return {size * left.x, size * left.y};
}

}  // namespace

void Belief::set(const Pose& pose) {
  pose_ = pose;
  past_.fill(pose);
  fixes_ = headings_ = 0;
}

void Belief::jump(const Pose& displacement) {
  pose_ = compose(pose_, displacement);
  past_.fill(pose_);
}

void Belief::move(double x_m, double y_m, double turn_rad) {
  const double way = std::hypot(x_m, y_m);
  moved_m_ += way;
  const double turned = turn_rad + drift_rad_per_m_ * way;
  // The gait turns while it moves: along the middle heading.
  pose_ = compose({pose_.x, pose_.y, pose_.yaw + 0.5 * turned}, {x_m, y_m, 0.0});
  pose_.yaw = normalizedAngle(pose_.yaw + 0.5 * turned);
  newest_ = (newest_ + 1) % kPast;
  past_[newest_] = pose_;
}

void Belief::doubt() {
  fixes_ = headings_ = 0;
  weight_ = 0.0;
}

void Belief::correct(const Senses& senses, bool is_lying) {
  if (!senses.pose) {
    if (senses.heading_rad) correctHeading(normalizedAngle(*senses.heading_rad - pose_.yaw));
    return;
  }
  const Pose& then = at(senses.pose->stamp_s, senses.now_s);
  const Pose& measured = senses.pose->pose;
  ++fixes_;
  const double gain = std::max(settings_.gain, 1.0 / (weight_ + fixes_));
  Point off{gain * (measured.x - then.x), gain * (measured.y - then.y)};
  if (is_lying) off = across(off, pose_.yaw);
  for (Pose& past : past_) past.x += off.x, past.y += off.y;
  pose_.x += off.x;
  pose_.y += off.y;
  const double turned = normalizedAngle(measured.yaw - then.yaw);
  if (moved_m_ > 0.0 && headings_ > kFirst)
    drift_rad_per_m_ = std::clamp(drift_rad_per_m_ + settings_.drift_gain * turned, -kMostDrift, kMostDrift);
  correctHeading(turned);
}

void Belief::correctHeading(double off_rad) {
  ++headings_;
  const double gain = std::max(settings_.heading_gain, 1.0 / (weight_ + headings_));
  moved_m_ = 0.0;
  for (Pose& past : past_) past.yaw = normalizedAngle(past.yaw + gain * off_rad);
  pose_.yaw = normalizedAngle(pose_.yaw + gain * off_rad);
}

const Pose& Belief::at(double stamp_s, double now_s) const {
  const double ago = std::clamp(std::round((now_s - stamp_s) / settings_.tick_s), 0.0, kPast - 1.0);
  return past_[(newest_ + kPast - static_cast<std::size_t>(ago)) % kPast];
}

}  // namespace underway
