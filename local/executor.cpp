#include "local/executor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "local/low.hpp"

namespace underway {

Executor::Executor(std::shared_ptr<const Robot> robot, const ExecutorSettings& settings)
    : robot_(std::move(robot)),
      settings_(settings),
      limits_(standingLimits(*robot_)),
      belief_(settings.belief),
      follow_(settings.follow, robot_, Beams{}),
      surroundings_(settings.surroundings, robot_) {}

void Executor::follow(Plan plan, std::shared_ptr<const World> world, const World& map) {
  surroundings_.expect(map, plan);
  checker_ = std::make_shared<const Checker>(std::move(world), robot_);
  plan_ = std::move(plan);
  segment_ = 0;
  state_ = State::kIdle;
  is_stroke_ = false;
  if (!has_pose_ && !plan_.segments.empty()) belief_.set(plan_.segments.front().motion.from);
  beginSegment();
}

void Executor::stop() {
  plan_ = {};
  checker_.reset();
  segment_ = 0;
  state_ = State::kIdle;
}

Tick Executor::tick(const Senses& senses) {
  believe(senses);
  surroundings_.see(senses, belief_.pose());
  finishSegments(senses);
  watchProgress();
  const State before = state_;
  state_ = transition(state_, situation(senses));
  if (state_ != before) idle_s_ = 0.0, aligned_ticks_ = 0;
  last_ = commandFor(senses);
  return {last_, state_};
}

// --- belief ------------------------------------------------------------------------------------------------

void Executor::believe(const Senses& senses) {
  if (!is_told_) mode_ = senses.mode, cycles_ = senses.cycles, is_told_ = true;
  if (!has_pose_ && senses.pose) belief_.set(senses.pose->pose), has_pose_ = true;
  if (senses.mode != mode_) {
    if (const Switch* change = robot_->findSwitch(mode_, senses.mode)) belief_.jump(change->displacement);
    mode_ = senses.mode;
    crawled_ = 0;
    strokes_ = 0.0;
    is_stroke_ = false;
  }
  const double tick = settings_.tick_s;
  if (isLow(*robot_, mode_))
    believeStrokes(senses.cycles);
  else
    belief_.move(last_.velocity.x_mps * tick, last_.velocity.y_mps * tick, last_.velocity.turn_radps * tick);
  cycles_ = senses.cycles;
  stroke_s_ = is_stroke_ ? stroke_s_ + tick : 0.0;
  belief_.correct(senses, isLow(*robot_, mode_));
  watchLocalisation(senses);
}

/// A stroke counts when its cycle has ended. A count that falls, or jumps, is of a robot that has begun anew.
void Executor::believeStrokes(std::uint64_t cycles) {
  constexpr std::uint64_t kMost = 3;  // between two words of the robot
  const std::uint64_t made = cycles - cycles_;
  const bool is_made = made > 0 && made <= kMost;
  const double way_m = is_made ? stride_ * settings_.crawl.kept * settings_.crawl.stroke_m : 0.0;
  belief_.move(is_made ? static_cast<double>(made) * way_m : 0.0, 0.0, 0.0);
  if (!is_made) return;
  crawled_ += static_cast<int>(made);
  strokes_ += static_cast<double>(made) * stride_ * stride_;
  is_stroke_ = false;
}

/// A fix that is missing now and then does not matter; after a silence of some length, or a fall, what was
/// believed before does not.
void Executor::watchLocalisation(const Senses& senses) {
  const bool should_know = !isLow(*robot_, mode_) && !senses.is_switching;
  silent_s_ = should_know && !senses.pose ? silent_s_ + settings_.tick_s : 0.0;
  if (!should_know && !senses.pose) belief_.countAnew();
  if (silent_s_ > settings_.lost_after_s || senses.has_fallen) belief_.doubt();
}

// --- where in the plan -------------------------------------------------------------------------------------

const Segment* Executor::current() const {
  return segment_ < plan_.segments.size() ? &plan_.segments[segment_] : nullptr;
}

Next Executor::next() const {
  const Segment* segment = current();
  if (segment == nullptr) return Next::kNothing;
  const Motion& motion = segment->motion;
  if (motion.kind != MotionKind::kSwitch) return isLow(*robot_, motion.mode) ? Next::kCrawl : Next::kMove;
  if (isLow(*robot_, motion.mode) == isLow(*robot_, motion.to_mode)) return Next::kMove;
  return isLow(*robot_, motion.to_mode) ? Next::kDown : Next::kUp;
}

void Executor::beginSegment() {
  best_progress_ = -1.0;
  idle_s_ = 0.0;
  looked_s_ = 0.0;
  is_looking_ = false;
  look_sense_ = 0.0;
  shift_m_ = 0.0;
  if (const Segment* segment = current()) {
    follow_.begin(*segment, belief_.pose(), *checker_);
    surroundings_.passBy(segment->closeness.clearance_m);
    if (next() == Next::kDown) passage_ = passageFrom(plan_, *robot_, segment_);
  }
}

bool Executor::isDone(const Segment& segment, const Senses& senses) const {
  const Motion& motion = segment.motion;
  if (motion.kind == MotionKind::kSwitch) return !senses.is_switching && senses.mode == motion.to_mode;
  if (!isLow(*robot_, motion.mode))
    return state_ == State::kWalking && (follow_.isDone(segment, belief_.pose()) || isTriggered());
  if (const auto& papers = settings_.crawl.papers) return !is_stroke_ && crawled_ >= papers->cycles;
  constexpr double kShort_m = 0.02;  // a stroke shorter than this is not worth it
  return !is_stroke_ && onLane(motion, belief_.pose()).along_m > length(motion) - kShort_m;
}

void Executor::finishSegments(const Senses& senses) {
  while (current() != nullptr && isDone(*current(), senses)) {
    ++segment_;
    beginSegment();
  }
}

void Executor::watchProgress() {
  constexpr double kProgress = 0.02;  // [m], [rad]; what the guard lets through bit by bit is none
  idle_s_ += settings_.tick_s;
  if (next() != Next::kMove || current()->motion.kind == MotionKind::kSwitch) return;
  const double progress = follow_.progress(*current(), belief_.pose());
  if (progress < best_progress_ + kProgress) return;
  best_progress_ = progress;
  idle_s_ = 0.0;
}

// --- the situation -----------------------------------------------------------------------------------------

Situation Executor::situation(const Senses& senses) {
  Situation is;
  is.has_plan = checker_ != nullptr;
  is.has_fallen = senses.has_fallen;
  is.is_settled = belief_.fixes() >= settings_.settled_fixes;
  is.is_lost = silent_s_ > settings_.lost_after_s;
  is.is_switching = senses.is_switching;
  is.next = next();
  if (state_ == State::kWalking || state_ == State::kAligning) is.is_blocked = isBlocked();
  if (is.next == Next::kDown && state_ == State::kAligning) is.is_aligned = isAligned();
  if (is.next == Next::kUp && state_ == State::kCrawling) is.has_room_up = hasRoomUpHere();
  if (state_ != State::kStalled) stalled_by_ = is.has_room_up ? "" : stalledBy();
  is.is_stalled = !stalled_by_.empty();
  return is;
}

bool Executor::isBlocked() {
  const Segment* segment = current();
  if (segment == nullptr) return false;
  constexpr double kLongestLook_s = 40.0;  // once round
  constexpr double kPatience = 4.0;        // aligning takes longer
  const double patience = state_ == State::kAligning ? kPatience : 1.0;
  is_held_ = false;
  const bool is_by_papers = settings_.crawl.papers && next() == Next::kDown;  // goes down elsewhere
  if (!is_by_papers && follow_.isAstray(*segment, belief_.pose())) return true;
  is_held_ = looked_s_ > kLongestLook_s || idle_s_ > settings_.stuck_after_s * patience;
  if (is_held_) return true;
  const Motion& motion = segment->motion;
  if (motion.kind == MotionKind::kTurn) return surroundings_.isTurnBlocked(belief_.pose());
  if (motion.kind == MotionKind::kSwitch) return isPassageBlocked();
  if (isLow(*robot_, motion.mode)) return false;
  const double along = onLane(motion, belief_.pose()).along_m;
  const auto shift = surroundings_.shiftAround(motion, along, follow_.allowance());
  shift_m_ = shift.value_or(0.0);
  return !shift;
}

// --- commands ----------------------------------------------------------------------------------------------

Command Executor::commandFor(const Senses& senses) {
  switch (state_) {
    case State::kWalking:
      if (current()->motion.kind == MotionKind::kSwitch) return {{}, current()->motion.to_mode};
      return {walkOn(senses), std::nullopt, lookRad(senses.now_s)};
    case State::kAligning:
      return {surroundings_.guarded(holdAt(entry(), belief_.pose(), settings_.follow.hold, limits_)),
              std::nullopt};
    case State::kGoingDown:
    case State::kGettingUp:
      if (senses.is_switching || current() == nullptr) return {};
      return {{}, current()->motion.to_mode};
    case State::kCrawling:
      return {crawlOn(), std::nullopt};
    default:
      return {};
  }
}

/// Before it goes backwards over floor that no beam has passed, it turns until that is seen, and then back:
/// to the side where that takes less, if it has room. 1 is to the left, -1 to the right, 0 that it need not.
double Executor::turnToLook() {
  constexpr double kBeyond_rad = 0.1;  // the edge of what it sees
  const Motion& motion = current()->motion;
  if (motion.kind != MotionKind::kTranslate || motion.sense != Sense::kBackward) return 0.0;
  const Pose& here = belief_.pose();
  const auto unseen = surroundings_.unseenBehind(motion, onLane(motion, here).along_m, here);
  if (!unseen) return look_sense_ = 0.0;
  const double margin_m = robot_->margin_m;
  const bool is_free = checker_->isFree(stay(motion.mode, here), margin_m);
  const TurningRoom room = is_free ? checker_->turningRoom(motion.mode, here, margin_m) : TurningRoom{};
  const double to_left = counterClockwise(0.0, *unseen) + Beams{}.first_rad + kBeyond_rad;
  const double to_right = counterClockwise(0.0, -*unseen) + Beams{}.first_rad + kBeyond_rad;
  const bool has_left = to_left < room.left_rad;
  const bool has_right = to_right < room.right_rad;
  if (look_sense_ > 0.0 ? has_left : has_right && look_sense_ < 0.0) return look_sense_;
  if (!has_left && !has_right) return look_sense_ = 0.0;
  return look_sense_ = has_left && (!has_right || to_left < to_right) ? 1.0 : -1.0;
}

Velocity Executor::walkOn(const Senses& senses) {
  constexpr double kBack_rad = 0.05;
  if (const double sense = turnToLook(); sense != 0.0) {
    is_looking_ = true;
    looked_s_ += settings_.tick_s;
    idle_s_ = -looked_s_;  // as long to turn back
    return surroundings_.guarded({0.0, 0.0, sense * limits_.turn_radps});
  }
  const double turned = normalizedAngle(belief_.pose().yaw - current()->motion.from.yaw);
  is_looking_ = is_looking_ && std::abs(turned) > kBack_rad;
  if (is_looking_) return surroundings_.guarded({0.0, 0.0, std::copysign(limits_.turn_radps, -turned)});
  return surroundings_.guarded(follow_.along(*current(), belief_.pose(), senses.scan, shift_m_));
}

/// Where the robot goes. A head does not look straight back: one that walks backwards glances over either
/// shoulder in turn, or it would see only half of what it comes to.
double Executor::lookRad(double now_s) const {
  const Motion& motion = current()->motion;
  constexpr double kIntoTurn_rad = 0.8;
  constexpr double kGlance_s = 1.0;
  if (motion.kind == MotionKind::kTurn) return std::copysign(kIntoTurn_rad, motion.angle_rad);
  if (motion.sense != Sense::kBackward) return angleOf(motion.sense);
  const double half_field = robot_->senses.depth ? 0.5 * robot_->senses.depth->field_rad : 0.0;
  const bool is_left = std::fmod(now_s, 2.0 * kGlance_s) < kGlance_s;
  return (is_left ? 1.0 : -1.0) * (std::numbers::pi - half_field);
}

std::vector<Point> Executor::unseenFloor() const {
  constexpr double kReach_m = 0.6;
  return surroundings_.unseenNear(belief_.pose().position(), kReach_m);
}

bool Executor::isSettled() const {
  return isLow(*robot_, mode_) || belief_.fixes() >= settings_.settled_fixes;
}

std::vector<Point> Executor::surprises() const {
  constexpr double kReach_m = 2.5;
  return surroundings_.surprisesNear(belief_.pose().position(), kReach_m);
}

}  // namespace underway
