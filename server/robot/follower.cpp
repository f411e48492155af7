#include "server/robot/follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/robot/pending_plans.hpp"

namespace underway {
namespace {

constexpr double kTick_s = 0.1;
constexpr int kFixes = 10;  // that the place it is met at is the mean of

/// Whether an error means that asking on is of no use, and no answer to the question either.
bool isFatal(ErrorCode code) {
  return code == ErrorCode::kInvalidRequest || code == ErrorCode::kInvalidMap ||
         code == ErrorCode::kInvalidRobot || code == ErrorCode::kInternal;
}

/// Has the robot stand still when it goes.
struct StandStill {
  explicit StandStill(DriverEnd& whose) : end(whose) {}
  ~StandStill() {
    (void)end.send(0, {});
    end.flush();
  }
  StandStill(const StandStill&) = delete;
  StandStill& operator=(const StandStill&) = delete;
  DriverEnd& end;
};

/// Means of positions and headings.
class MeanPose {
 public:
  void add(const Pose& pose) {
    ++count_;
    x_ += pose.x;
    y_ += pose.y;
    ahead_ = {ahead_.x + std::cos(pose.yaw), ahead_.y + std::sin(pose.yaw)};
  }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] Pose pose() const { return {x_ / count_, y_ / count_, std::atan2(ahead_.y, ahead_.x)}; }

 private:
  int count_ = 0;
  double x_ = 0.0;
  double y_ = 0.0;
  Point ahead_;
};

}  // namespace

/// Waits for senses that were not there yet; false when none came, or it was told to stop.
Expected<bool> Follower::listen(const std::stop_token& stop) {
  const auto patience = settings_.period * (is_fresh_ || !has_heard_ ? 3 : 2) / 2;
  is_fresh_ = false;
  while (!stop.stop_requested()) {
    auto heard = end_->hear(Clock::now() + patience);
    if (!heard) return tl::unexpected(heard.error());
    if (!*heard && !settings_.is_in_step) return false;
    if (!*heard && Clock::now() - heard_at_ > settings_.robot_silent) return false;
    if (!*heard) continue;
    const bool is_again = has_heard_ && (*heard)->tick != 0 && (*heard)->tick == heard_.tick;
    heard_at_ = Clock::now();
    if (is_again) {  // our answer did not get there
      if (const auto sent = end_->send(heard_.tick, last_); !sent) return tl::unexpected(sent.error());
      continue;
    }
    heard_ = std::move(**heard);
    has_heard_ = is_fresh_ = true;
    return true;
  }
  return false;
}

/// What was heard last, by our own clock; without anything new only what does not change by itself.
Senses Follower::sensesNow() {
  constexpr double kOldest_s = 1.5;
  now_s_ += kTick_s;
  Senses senses = heard_.senses();
  const double then_s = senses.now_s;
  senses.now_s = now_s_;
  if (!is_fresh_) {
    senses.scan = senses.depth = nullptr;
    senses.pose.reset();
    senses.heading_rad.reset();
  }
  if (senses.pose) senses.pose->stamp_s = now_s_ - std::clamp(then_s - senses.pose->stamp_s, 0.0, kOldest_s);
  return senses;
}

Expected<void> Follower::answer(const Command& command) {
  last_ = command;
  return end_->send(is_fresh_ ? heard_.tick : 0, command);
}

Error Follower::unheard() const {
  const double s = std::chrono::duration<double>(settings_.robot_timeout).count();
  std::string text =
      has_heard_ ? "the robot is not heard any more: see whether it is still there"
                 : "no robot was heard for " + std::to_string(std::lround(s)) +
                       " s: start it (or 'underway sim') with the same name, domain and network setting";
  if (!has_heard_ && !end_->fault().empty())
    text = "what the robot tells is malformed, " + end_->fault() +
           ": check that both are of the same version and robot file";
  return {ErrorCode::kInternal, std::move(text), {}};
}

Expected<Met> Follower::meet(const std::stop_token& stop) {
  const auto until = Clock::now() + settings_.robot_timeout;
  heard_at_ = Clock::now();
  MeanPose mean;
  for (int silent = 0; mean.count() < kFixes && silent < kFixes;) {
    const auto heard = listen(stop);
    if (!heard) return tl::unexpected(heard.error());
    if (stop.stop_requested()) return fail(ErrorCode::kCancelled, "stopped before it began");
    if (!*heard && Clock::now() > until) return tl::unexpected(unheard());
    if (!*heard) continue;
    if (const auto sent = answer({}); !sent) return tl::unexpected(sent.error());
    if (heard_.rest.pose) mean.add(heard_.rest.pose->pose);
    silent += heard_.rest.pose ? 0 : 1;
  }
  Met met{std::nullopt, heard_.rest.mode};
  if (mean.count() > 0) met.pose = mean.pose();
  return met;
}

/// The error that ends the journey, if there is one.
std::optional<Error> Follower::giveUp(const Mission& mission) const {
  if (!is_fresh_ && Clock::now() - heard_at_ > settings_.robot_silent) return unheard();
  if (!refused_) return std::nullopt;
  if (isFatal(refused_->code)) return refused_;
  const bool is_away = refused_->code == ErrorCode::kNoServer || refused_->code == ErrorCode::kCancelled;
  const bool is_long = mission.plans() == 0 || Clock::now() - served_at_ > settings_.server_silent;
  return is_away && is_long ? refused_ : std::nullopt;
}

Expected<JourneyEnd> Follower::drive(const std::shared_ptr<const World>& map,
                                     const std::shared_ptr<const Robot>& robot, const Request& request,
                                     PlanSource source, const std::stop_token& stop, const Watch& watch) {
  if (!settings_.is_in_step) source = asking(std::move(source));
  const auto noted = [&](const Request& asked, const std::shared_ptr<const World>& world) {
    if (!refused_) served_at_ = Clock::now();
    auto plan = source(asked, world);
    if (plan)
      refused_.reset();
    else if (plan.error().code != ErrorCode::kBusy)
      refused_ = plan.error();
    return plan;
  };
  Mission mission(map, robot, request, noted);
  const StandStill in_the_end(*end_);  // before an answer under way is waited for
  heard_at_ = Clock::now();
  while (!stop.stop_requested()) {
    const auto heard = listen(stop);
    if (!heard) return tl::unexpected(heard.error());
    if (stop.stop_requested()) break;
    const Tick tick = mission.tick(sensesNow());
    if (const auto sent = answer(tick.command); !sent) return tl::unexpected(sent.error());
    if (watch) watch(mission, tick, heard_);
    if (auto error = giveUp(mission)) return tl::unexpected(std::move(*error));
    if (mission.outcome() != Mission::Outcome::kUnderway) return JourneyEnd{mission.outcome(), mission.why()};
  }
  return JourneyEnd{Mission::Outcome::kUnderway, "the robot was told to stand still"};
}

}  // namespace underway
