#include "planner/movable.hpp"

#include <algorithm>
#include <cmath>

#include "planner/roadmap.hpp"

namespace underway {
namespace {

constexpr double kShortest_m = 1e-3;       // of a line that is made shorter
constexpr double kTurned_rad_per_m = 0.5;  // so that the ends of a line of some metres move by about a step

/// The pose so far along a translation's line, from a pose on it.
Pose along(const Motion& line, const Pose& from, double way_m) {
  const double angle = angleOf(line.sense);
  return compose(from, {way_m * std::cos(angle), way_m * std::sin(angle), 0.0});
}

}  // namespace

Movable::Rules Movable::Rules::at(std::span<const Passage::Step> steps, std::size_t i) const {
  const Option& here = steps[i].option;
  const auto& modes = checker->robot().modes;
  Rules rules = *this;
  rules.is_start =
      i == 1 && !steps[1].way && steps[0].option.out == here.in && !modes[here.in_mode].canTurn();
  rules.is_goal = i + 2 == steps.size() && !steps.back().way && steps.back().option.in == here.out &&
                  !modes[here.out_mode].canTurn();
  return rules;
}

Movable::Movable(const Rules& rules, Route motions)
    : rules_(rules),
      motions_(std::move(motions)),
      cost_(costOf(rules.checker->robot(), rules.policy, motions_)) {}

std::optional<Movable> Movable::moved(Move move, double step_m) const {
  const double turned = kTurned_rad_per_m * step_m;
  switch (move) {
    case Move::kAhead:
      return shifted({step_m, 0.0, 0.0});
    case Move::kBack:
      return shifted({-step_m, 0.0, 0.0});
    case Move::kLeft:
      return shifted({0.0, step_m, 0.0});
    case Move::kRight:
      return shifted({0.0, -step_m, 0.0});
    case Move::kTurnedLeft:
      return shifted({0.0, 0.0, turned});
    case Move::kTurnedRight:
      return shifted({0.0, 0.0, -turned});
    case Move::kLaterEntry:
      return withEntry(step_m);
    case Move::kEarlierEntry:
      return withEntry(-step_m);
    case Move::kLaterExit:
      return withExit(step_m);
    case Move::kEarlierExit:
      return withExit(-step_m);
  }
  return std::nullopt;
}

/// The one translation, if there is one and no more.
std::optional<std::size_t> Movable::line() const {
  const auto is_line = [](const Motion& motion) { return motion.kind == MotionKind::kTranslate; };
  const auto first = std::find_if(motions_.begin(), motions_.end(), is_line);
  if (first == motions_.end() || std::any_of(first + 1, motions_.end(), is_line)) return std::nullopt;
  return static_cast<std::size_t>(first - motions_.begin());
}

/// By a pose in the body frame, about the middle of the line.
std::optional<Movable> Movable::shifted(const Pose& by) const {
  if (rules_.is_start || rules_.is_goal) return std::nullopt;
  if (const auto on = line()) {
    const Motion& old = motions_[*on];
    const double half_m = 0.5 * length(old);
    const Pose middle = compose(along(old, old.from, half_m), by);
    return withLine(*on, along(old, middle, -half_m), 2.0 * half_m);
  }
  if (motions_.size() != 1) return std::nullopt;
  const Switch& change = *rules_.checker->robot().findSwitch(motions_[0].mode, motions_[0].to_mode);
  return Movable(rules_, {switchModes(change, compose(motions_[0].from, by))});
}

std::optional<Movable> Movable::withEntry(double later_m) const {
  const auto on = line();
  if (rules_.is_start || !on || *on == 0) return std::nullopt;
  const Motion& old = motions_[*on];
  const double length_m = length(old) - later_m;
  if (length_m < kShortest_m) return std::nullopt;
  return withLine(*on, along(old, old.from, later_m), length_m);
}

std::optional<Movable> Movable::withExit(double later_m) const {
  const auto on = line();
  if (rules_.is_goal || !on || *on + 1 == motions_.size()) return std::nullopt;
  const double length_m = length(motions_[*on]) + later_m;
  if (length_m < kShortest_m) return std::nullopt;
  return withLine(*on, motions_[*on].from, length_m);
}

/// All motions anew, round a line from a pose; what is fixed stays as it is, bit for bit.
Movable Movable::withLine(std::size_t on, const Pose& from, double length_m) const {
  const Robot& robot = rules_.checker->robot();
  const auto change_at = [&](std::size_t i) -> const Switch& {
    return *robot.findSwitch(motions_[i].mode, motions_[i].to_mode);
  };
  Route motions = motions_;
  Pose low = from;
  for (std::size_t i = on; i-- > 0;) {
    if (rules_.is_start) break;
    const Switch& change = change_at(i);
    motions[i] = switchModes(change, before(low, change.displacement));
    motions[i].to.yaw = low.yaw;  // bit for bit: the line keeps its heading
    low = motions[i].from;
  }
  const Motion& old = motions_[on];
  motions[on] = translate(old.mode, old.sense, on > 0 ? motions[on - 1].to : from, length_m);
  if (rules_.is_goal) {
    motions[on].to = old.to;
  } else {
    for (std::size_t i = on + 1; i < motions.size(); ++i)
      motions[i] = switchModes(change_at(i), motions[i - 1].to);
  }
  return {rules_, std::move(motions)};
}

Option Movable::option() const {
  return {entry(),
          exit(),
          motions_.front().mode,
          motions_.back().to_mode,
          false,
          false,
          rules_.checker->robot().margin_m,
          motions_,
          cost_};
}

bool Movable::isFree() const {
  const double margin = rules_.checker->robot().margin_m;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    double keep = margin;
    if (rules_.is_start && i == 0) keep = std::min(keep, rules_.start_m);
    if (rules_.is_goal && i + 1 == motions_.size()) keep = std::min(keep, rules_.goal_m);
    keep = keep < margin ? keep : std::max(keep, rules_.at_least_m);
    if (!isFreeKeeping(*rules_.checker, motions_[i], keep)) return false;
  }
  return true;
}

}  // namespace underway
