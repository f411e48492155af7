#include "planner/proof/stances.hpp"

#include <algorithm>

namespace underway::proof {
namespace {

bool holds(Range outer, Range inner) { return outer.min <= inner.min && outer.max >= inner.max; }

bool contains(const std::vector<Sense>& senses, Sense sense) {
  return std::find(senses.begin(), senses.end(), sense) != senses.end();
}

/// Whether a switch asks for nothing that both its modes do not ask for where they stand.
bool isFreeOfCharge(const Robot& robot, const Switch& change) {
  const Mode& a = robot.modes[change.from];
  const Mode& b = robot.modes[change.to];
  return change.displacement == Pose{} && a.body_m == b.body_m && a.step_over_m == b.step_over_m &&
         holds(a.body_m.x, change.body_m.x) && holds(a.body_m.y, change.body_m.y) &&
         change.body_m.z.max <= a.body_m.z.max;
}

/// The first of the modes that each stands together with.
std::vector<ModeId> firstOfStance(const Robot& robot) {
  std::vector<ModeId> first;
  for (std::size_t mode = 0; mode < robot.modes.size(); ++mode) first.push_back(static_cast<ModeId>(mode));
  for (const Switch& change : robot.switches) {
    if (!isFreeOfCharge(robot, change)) continue;
    const auto [low, high] = std::minmax({first[change.from], first[change.to]});
    std::replace(first.begin(), first.end(), high, low);
  }
  return first;
}

}  // namespace

Stances stancesOf(const Checker& checker, double margin_m) {
  const Robot& robot = checker.robot();
  Stances result;
  const auto add_shape = [&](const BodyBox& body, const Motion& motion) {
    result.shapes.push_back({{body.x, body.y, margin_m}, &checker.seenBy(motion)});
    return result.shapes.size() - 1;
  };
  const std::vector<ModeId> first = firstOfStance(robot);
  for (std::size_t id = 0; id < robot.modes.size(); ++id) {
    const Mode& mode = robot.modes[id];
    if (first[id] == id) {
      result.of_mode.push_back(static_cast<std::uint32_t>(result.all.size()));
      result.all.emplace_back();
      result.all.back().shape = add_shape(mode.body_m, stay(static_cast<ModeId>(id), {}));
    } else {
      result.of_mode.push_back(result.of_mode[first[id]]);
    }
    Stance& stance = result.all[result.of_mode.back()];
    stance.modes.push_back(static_cast<ModeId>(id));
    stance.can_turn = stance.can_turn || mode.canTurn();
    for (const Sense sense : kSenses)
      if (mode.canMove(sense) && !contains(stance.senses, sense)) stance.senses.push_back(sense);
  }
  for (std::size_t i = 0; i < robot.switches.size(); ++i) {
    const Switch& change = robot.switches[i];
    if (isFreeOfCharge(robot, change)) continue;
    result.all[result.of_mode[change.from]].exits.push_back(
        {i, add_shape(change.body_m, switchModes(change, {})), result.of_mode[change.to],
         change.displacement});
  }
  return result;
}

}  // namespace underway::proof
