// The executor's part in low passages: when to lie down, how to crawl, when to get up.

#include <algorithm>
#include <cmath>

#include "local/executor.hpp"
#include "local/low.hpp"

namespace underway {
namespace {

constexpr double kShortestStride = 0.25;  // of a stroke

}  // namespace

/// Whether something unmapped stands where it is to lie down, along the crawl or where it is to get up, as
/// far as it was seen.
bool Executor::isPassageBlocked() const {
  if (next() != Next::kDown) return false;
  const Motion& down = current()->motion;
  const Switch* change = robot_->findSwitch(down.mode, down.to_mode);
  if (change != nullptr && surroundings_.isBoxBlocked(change->body_m, belief_.pose())) return true;
  for (std::size_t i = segment_ + 1; i < plan_.segments.size(); ++i) {
    const Motion& motion = plan_.segments[i].motion;
    if (motion.kind == MotionKind::kSwitch) {
      const Switch* up = robot_->findSwitch(motion.mode, motion.to_mode);
      return up != nullptr && surroundings_.isBoxBlocked(up->body_m, motion.from);
    }
    if (isLow(*robot_, motion.mode) && surroundings_.isWholeLaneBlocked(motion)) return true;
  }
  return false;
}

Pose Executor::entry() const {
  return entryOf(passage_, plan_, settings_.crawl.keeps_heading ? 0.0 : belief_.drift(), *checker_);
}

/// By the papers' trigger: on its way straight on to where the plan goes down, it is close enough to do so.
bool Executor::isTriggered() const {
  constexpr double kFacing_rad = 0.1;
  if (!settings_.crawl.papers || next() != Next::kMove) return false;
  const Motion& now = current()->motion;
  if (now.kind == MotionKind::kTranslate && now.sense != Sense::kForward) return false;
  std::size_t after = segment_ + 1;
  while (after < plan_.segments.size() && plan_.segments[after].motion.kind == MotionKind::kTurn) ++after;
  if (after >= plan_.segments.size()) return false;
  const Motion& down = plan_.segments[after].motion;
  const Pose& here = belief_.pose();
  return down.kind == MotionKind::kSwitch && isLow(*robot_, down.to_mode) &&
         std::abs(normalizedAngle(down.from.yaw - here.yaw)) < kFacing_rad &&
         isNearLow(*checker_, down.mode, down.to_mode, here, settings_.crawl.papers->threshold_m);
}

bool Executor::isAligned() {
  if (settings_.crawl.papers) return true;
  const Pose there = entry();
  Motion lane = current()->motion;
  lane.from = {there.x, there.y, lane.from.yaw};
  const OnLane off = onLane(lane, belief_.pose());
  constexpr double kBehind_m = 0.02;  // further back than it should be matters less
  const bool is_in = std::abs(off.left_m) < passage_.tolerance_m && off.along_m < passage_.tolerance_m &&
                     off.along_m > -kBehind_m &&
                     std::abs(normalizedAngle(belief_.pose().yaw - there.yaw)) < passage_.tolerance_rad;
  aligned_ticks_ = is_in ? aligned_ticks_ + 1 : 0;
  return aligned_ticks_ >= settings_.crawl.aligned_ticks;
}

/// By the map, and by what is seen that it does not have.
bool Executor::hasRoomUpHere() const {
  if (settings_.crawl.papers) return !is_stroke_;
  const Switch* up = robot_->findSwitch(current()->motion.mode, current()->motion.to_mode);
  return !is_stroke_ && !surroundings_.isBoxBlocked(up->body_m, belief_.pose()) &&
         hasRoomUp(*checker_, *up, belief_.pose(),
                   settings_.crawl.sigmas * sigmaAfter(strokes_, settings_.crawl));
}

/// Empty as long as it can go on.
std::string_view Executor::stalledBy() const {
  if (state_ == State::kCrawling) return crawlStalledBy();
  const bool is_changing = state_ == State::kGoingDown || state_ == State::kGettingUp;
  const Segment* segment = current();
  if (!is_changing || segment == nullptr || segment->motion.kind != MotionKind::kSwitch) return "";
  constexpr double kSpare_s = 10.0;
  return idle_s_ > 2.0 * segment->duration_s + kSpare_s ? "the gait does not change to the other mode" : "";
}

std::string_view Executor::crawlStalledBy() const {
  if (is_stroke_) return stroke_s_ > settings_.crawl.stall_s ? "the crawl does not progress" : "";
  if (next() == Next::kUp) return strideOn() > 0.0 ? "" : "there is no room to get up";
  const Segment* segment = current();
  if (segment == nullptr || next() != Next::kCrawl) return "";
  const double along = onLane(segment->motion, belief_.pose()).along_m;
  return surroundings_.isLaneBlocked(segment->motion, along)
             ? "something that is not in the map lies in its way"
             : "";
}

/// Beyond the planned end, looking for room to get up: the share of a stroke that there is room for, 0 if
/// none.
double Executor::strideOn() const {
  const Pose& here = belief_.pose();
  constexpr double kMargin_m = 0.005;
  constexpr double kSigmas = 2.0;  // that it may have come further than it believes
  const double unsure_m = kSigmas * sigmaAfter(strokes_, settings_.crawl);
  if (distance(here.position(), current()->motion.from.position()) >= settings_.crawl.longest_extra_m)
    return 0.0;
  for (const double stride : {1.0, 0.5, kShortestStride}) {
    const auto on = [&](double beyond_m) {
      return translate(mode_, Sense::kForward, here, stride * settings_.crawl.stroke_m + beyond_m);
    };
    const double beyond_lane_m = std::max(unsure_m - settings_.surroundings.lane_margin_m, 0.0);
    if (checker_->isFree(on(unsure_m), kMargin_m) && !surroundings_.isWholeLaneBlocked(on(beyond_lane_m)))
      return stride;
  }
  return 0.0;
}

/// The share of a stroke that is left to the end of a segment, or of the search for room to get up.
double Executor::nextStride() const {
  if (settings_.crawl.papers) return 1.0;
  if (next() != Next::kCrawl) return strideOn();
  const double left = length(current()->motion) - onLane(current()->motion, belief_.pose()).along_m;
  return std::clamp(left / (settings_.crawl.stroke_m * settings_.crawl.kept), kShortestStride, 1.0);
}

/// One stroke after the other; the last one is shorter, so that it ends where it should.
Velocity Executor::crawlOn() {
  const double top = robot_->modes[mode_].speed(Sense::kForward);
  if (!is_stroke_) {
    if (current() == nullptr) return {};
    stride_ = nextStride();
    is_stroke_ = stride_ > 0.0;
  }
  return {stride_ * top, 0.0, 0.0};
}

}  // namespace underway
