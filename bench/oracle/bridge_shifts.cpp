#include "bench/oracle/bridge_shifts.hpp"

#include <algorithm>
#include <cmath>

namespace underway::bench {

/// What may change of a bridge.
struct BridgeShifts::Form {
  Pose entry;           ///< where its first motion begins
  double rail_m = 0.0;  ///< length of the translation, if it has one
};

namespace {

/// Index of the translation, or the number of motions.
std::size_t railOf(const Leg& leg) {
  const auto rail = std::find_if(leg.motions.begin(), leg.motions.end(),
                                 [](const Motion& motion) { return motion.kind == MotionKind::kTranslate; });
  return static_cast<std::size_t>(rail - leg.motions.begin());
}

}  // namespace

Leg BridgeShifts::legOf(const Leg& like, const Form& form) const {
  Leg leg;
  Pose at = form.entry;
  for (const Motion& motion : like.motions) {
    leg.motions.push_back(motion.kind == MotionKind::kSwitch
                              ? switchModes(*terrain_.robot().findSwitch(motion.mode, motion.to_mode), at)
                              : translate(motion.mode, motion.sense, at, form.rail_m));
    at = leg.motions.back().to;
  }
  leg.yaw_in = form.entry.yaw;
  leg.yaw_out = at.yaw;
  return leg;
}

bool BridgeShifts::isFree(const Leg& leg) const {
  return std::all_of(leg.motions.begin(), leg.motions.end(),
                     [&](const Motion& motion) { return terrain_.keep.isFree(motion); });
}

/// Halves what may still be cut off the rail, first at its beginning, then at its end.
void BridgeShifts::tighten(const Leg& like, Form& form) const {
  constexpr double kEnough_m = 1e-5;
  for (const bool is_beginning : {true, false}) {
    if (is_beginning ? is_start_fixed_ : is_end_fixed_) continue;
    double free = 0.0;
    double blocked = form.rail_m;
    while (blocked - free > kEnough_m) {
      const double cut = 0.5 * (free + blocked);
      Form shorter{form.entry, form.rail_m - cut};
      if (is_beginning) {
        const Motion& rail = like.motions[railOf(like)];
        const double direction = form.entry.yaw + angleOf(rail.sense);
        shorter.entry.x += cut * std::cos(direction);
        shorter.entry.y += cut * std::sin(direction);
      }
      (isFree(legOf(like, shorter)) ? free : blocked) = cut;
    }
    if (is_beginning) {
      const double direction = form.entry.yaw + angleOf(like.motions[railOf(like)].sense);
      form.entry.x += free * std::cos(direction);
      form.entry.y += free * std::sin(direction);
    }
    form.rail_m -= free;
  }
}

std::optional<Leg> BridgeShifts::shifted(const Leg& leg, std::optional<double> yaw, double shift_m,
                                         std::mt19937_64& random) const {
  std::normal_distribution<double> normal(0.0, shift_m);
  std::bernoulli_distribution coin(0.5);
  const std::size_t rail = railOf(leg);
  const bool has_rail = rail < leg.motions.size();
  Form form{leg.motions.front().from, has_rail ? length(leg.motions[rail]) : 0.0};
  const double reach_m = 0.5 + form.rail_m;  // how far a turn moves the ends
  if (!is_start_fixed_ && !is_end_fixed_) {
    const double turned = yaw            ? normalizedAngle(*yaw - form.entry.yaw)
                          : coin(random) ? normal(random) / reach_m
                                         : 0.0;
    // Turned about its middle, so that both ends move a little rather than one of them far.
    const Pose& end = leg.motions.back().to;
    const Point middle{0.5 * (form.entry.x + end.x), 0.5 * (form.entry.y + end.y)};
    const Point entry =
        transform({middle.x, middle.y, turned}, {form.entry.x - middle.x, form.entry.y - middle.y});
    form.entry = {entry.x, entry.y, yaw ? *yaw : normalizedAngle(form.entry.yaw + turned)};
    if (coin(random)) form.entry.x += normal(random), form.entry.y += normal(random);
  }
  if (has_rail && coin(random)) form.rail_m = std::max(0.0, form.rail_m + normal(random));
  Leg result = legOf(leg, form);
  if (is_end_fixed_) {
    // Only the length changes: move the entry so that it still ends at the goal.
    const Pose& end = leg.motions.back().to;
    form.entry.x += end.x - result.motions.back().to.x;
    form.entry.y += end.y - result.motions.back().to.y;
    result = legOf(leg, form);
    if (has_rail)
      result.motions.back() = translate(leg.motions.back().mode, leg.motions.back().sense,
                                        result.motions.back().from, end.position());
  }
  if (!isFree(result)) return std::nullopt;
  if (has_rail && coin(random)) {
    tighten(leg, form);
    if (!is_end_fixed_) result = legOf(leg, form);
  }
  return result;
}

}  // namespace underway::bench
