#include "bench/oracle/gaits.hpp"

#include <algorithm>

namespace underway::bench {
namespace {

bool isAtOnce(const Robot& robot, ModeId from, ModeId to) {
  const Switch* change = robot.findSwitch(from, to);
  return change != nullptr && change->duration_s == 0.0 && change->displacement == Pose{} &&
         change->body_m == robot.modes[from].body_m;
}

bool areCompanions(const Robot& robot, ModeId a, ModeId b) {
  const Mode& one = robot.modes[a];
  const Mode& other = robot.modes[b];
  return one.body_m == other.body_m && one.step_over_m == other.step_over_m && isAtOnce(robot, a, b) &&
         isAtOnce(robot, b, a);
}

/// The best of a gait's modes at something, by its speed.
template <class Speed>
std::optional<ModeId> best(const Robot& robot, const std::vector<ModeId>& modes, Policy policy,
                           const Speed& speed) {
  std::optional<ModeId> found;
  for (const ModeId mode : modes) {
    if (!(speed(robot.modes[mode]) > 0.0)) continue;
    if (!found || (policy != Policy::kPriority && speed(robot.modes[mode]) > speed(robot.modes[*found])))
      found = mode;
  }
  return found;
}

}  // namespace

bool Gait::movesToAllSides() const {
  return std::all_of(moving.begin(), moving.end(), [](const auto& mode) { return mode.has_value(); });
}

Gaits gaitsOf(const Robot& robot, Policy policy) {
  Gaits gaits;
  for (std::size_t i = 0; i < robot.modes.size(); ++i) {
    const auto mode = static_cast<ModeId>(i);
    const auto known = std::find_if(gaits.all.begin(), gaits.all.end(), [&](const Gait& gait) {
      return std::all_of(gait.modes.begin(), gait.modes.end(),
                         [&](ModeId other) { return areCompanions(robot, mode, other); });
    });
    gaits.of_mode.push_back(static_cast<GaitId>(known - gaits.all.begin()));
    if (known == gaits.all.end())
      gaits.all.push_back({{mode}, {}, {}});
    else
      known->modes.push_back(mode);
  }
  for (Gait& gait : gaits.all) {
    for (const Sense sense : kSenses)
      gait.moving[static_cast<std::size_t>(sense)] =
          best(robot, gait.modes, policy, [&](const Mode& mode) { return mode.speed(sense); });
    // A turn moves the body nowhere, so the fastest is best under every policy.
    gait.turning =
        best(robot, gait.modes, Policy::kFastest, [](const Mode& mode) { return mode.turn_speed_radps; });
  }
  return gaits;
}

}  // namespace underway::bench
