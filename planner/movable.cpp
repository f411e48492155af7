#include "planner/movable.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/roadmap.hpp"

namespace underway {
namespace {

constexpr double kShortest_m = 1e-3;  // of a line that is made shorter
constexpr double kTurned_rad_per_m = 0.5;

}  // namespace

Movable::Movable(const Rules& rules, Route motions, bool is_start, bool is_goal, double start_m,
                 double goal_m)
    : rules_(rules),
      motions_(std::move(motions)),
      is_start_(is_start),
      is_goal_(is_goal),
      start_m_(start_m),
      goal_m_(goal_m),
      cost_(costOf(rules.checker->robot(), rules.policy, motions_)) {}

/// The one translation of a crossing that has one, with switches at most on its two sides.
std::optional<std::size_t> Movable::line() const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    if (motions_[i].kind != MotionKind::kTranslate) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

std::optional<Movable> Movable::rebuilt(const Pose& line_from, double length_m) const {
  const Robot& robot = rules_.checker->robot();
  const std::size_t on = *line();
  const Motion& old = motions_[on];
  Route motions(motions_.size());
  Pose low = line_from;
  for (std::size_t i = on; i-- > 0;) {
    const Switch& change = *robot.findSwitch(motions_[i].mode, motions_[i].to_mode);
    motions[i] = switchModes(change, before(low, change.displacement));
    motions[i].to.yaw = low.yaw;  // bit for bit: the line keeps its heading
    low = motions[i].from;
  }
  const Pose from = on > 0 ? motions[on - 1].to : line_from;
  motions[on] = translate(old.mode, old.sense, from, length_m);
  if (is_goal_ && on + 1 == motions_.size()) motions[on].to = old.to;
  for (std::size_t i = on + 1; i < motions_.size(); ++i)
    motions[i] = switchModes(*robot.findSwitch(motions_[i].mode, motions_[i].to_mode), motions[i - 1].to);
  return Movable(rules_, std::move(motions), is_start_, is_goal_, start_m_, goal_m_);
}

std::optional<Movable> Movable::moved(Move move, double step_m) const {
  const auto on = line();
  const bool is_fixed = is_start_ || is_goal_;
  const bool turns = rules_.checker->robot().modes[motions_.front().mode].canTurn() &&
                     rules_.checker->robot().modes[motions_.back().to_mode].canTurn();
  if (!on) {  // a lone switch
    if (is_fixed || motions_.size() != 1 || !turns) return std::nullopt;
    const Switch& change = *rules_.checker->robot().findSwitch(motions_[0].mode, motions_[0].to_mode);
    constexpr std::array kShifts{Pose{1, 0, 0},  Pose{-1, 0, 0}, Pose{0, 1, 0},
                                 Pose{0, -1, 0}, Pose{0, 0, 1},  Pose{0, 0, -1}};
    const auto which = static_cast<std::size_t>(move);
    if (which >= kShifts.size()) return std::nullopt;
    const Pose shift{kShifts[which].x * step_m, kShifts[which].y * step_m,
                     kShifts[which].yaw * step_m * kTurned_rad_per_m};
    return Movable(rules_, {switchModes(change, compose(motions_[0].from, shift))}, false, false, start_m_,
                   goal_m_);
  }
  const Motion& old = motions_[*on];
  const double length_m = length(old);
  const double along = angleOf(old.sense);
  const auto shifted = [&](double ahead, double left, double turned) {
    // About the middle of the line.
    const Pose middle =
        compose(old.from, {0.5 * length_m * std::cos(along), 0.5 * length_m * std::sin(along), 0.0});
    const Pose moved_middle = compose(middle, {ahead * std::cos(along) - left * std::sin(along),
                                               ahead * std::sin(along) + left * std::cos(along), turned});
    return compose(moved_middle, {-0.5 * length_m * std::cos(along), -0.5 * length_m * std::sin(along), 0.0});
  };
  const auto from_ahead = [&](double ahead) {
    return compose(old.from, {ahead * std::cos(along), ahead * std::sin(along), 0.0});
  };
  const bool has_entry = *on > 0;
  const bool has_exit = *on + 1 < motions_.size();
  const double turned = kTurned_rad_per_m * step_m;
  switch (move) {
    case Move::kAhead:
      return is_fixed ? std::nullopt : rebuilt(shifted(step_m, 0, 0), length_m);
    case Move::kBack:
      return is_fixed ? std::nullopt : rebuilt(shifted(-step_m, 0, 0), length_m);
    case Move::kLeft:
      return is_fixed ? std::nullopt : rebuilt(shifted(0, step_m, 0), length_m);
    case Move::kRight:
      return is_fixed ? std::nullopt : rebuilt(shifted(0, -step_m, 0), length_m);
    case Move::kTurnedLeft:
      return is_fixed ? std::nullopt : rebuilt(shifted(0, 0, turned), length_m);
    case Move::kTurnedRight:
      return is_fixed ? std::nullopt : rebuilt(shifted(0, 0, -turned), length_m);
    case Move::kLaterEntry:
      if (is_start_ || !has_entry || length_m - step_m < kShortest_m) return std::nullopt;
      return rebuilt(from_ahead(step_m), length_m - step_m);
    case Move::kEarlierEntry:
      if (is_start_ || !has_entry) return std::nullopt;
      return rebuilt(from_ahead(-step_m), length_m + step_m);
    case Move::kLaterExit:
      if (is_goal_ || !has_exit) return std::nullopt;
      return rebuilt(old.from, length_m + step_m);
    case Move::kEarlierExit:
      if (is_goal_ || !has_exit || length_m - step_m < kShortest_m) return std::nullopt;
      return rebuilt(old.from, length_m - step_m);
  }
  return std::nullopt;
}

bool Movable::isFree() const {
  const double margin = rules_.checker->robot().margin_m;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    double keep = margin;
    if (is_start_ && i == 0) keep = std::min(keep, start_m_);
    if (is_goal_ && i + 1 == motions_.size()) keep = std::min(keep, goal_m_);
    if (!isFreeKeeping(*rules_.checker, motions_[i],
                       keep < margin ? keep : std::max(keep, rules_.at_least_m)))
      return false;
  }
  return true;
}

}  // namespace underway
