#include "local/drivable.hpp"

#include <algorithm>
#include <string>

#include "local/low.hpp"

namespace underway {
namespace {

bool movesAheadOnly(const Mode& mode) {
  return !mode.canTurn() && std::all_of(kSenses.begin(), kSenses.end(), [&](Sense sense) {
    return sense == Sense::kForward || !mode.canMove(sense);
  });
}

}  // namespace

Expected<void> checkDrivable(const Robot& robot) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorCode::kInvalidRobot,
                "robot \"" + robot.name + "\" can be planned for, but not driven: " + what);
  };
  for (std::size_t i = 0; i < robot.modes.size(); ++i)
    if (isLow(robot, static_cast<ModeId>(i)) && !movesAheadOnly(robot.modes[i]))
      return refuse("its low mode \"" + robot.modes[i].name +
                    "\" turns, or moves other than forward; take that out of its file, or drive it yourself");
  for (const Switch& change : robot.switches)
    if (isLow(robot, change.from) && isLow(robot, change.to))
      return refuse("it changes from one low mode, \"" + robot.modes[change.from].name +
                    "\", into another; take that out of its file, or drive it yourself");
  return {};
}

}  // namespace underway
