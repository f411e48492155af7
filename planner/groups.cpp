#include "planner/groups.hpp"

#include <algorithm>

namespace underway {

Groups::Groups(const Robot& robot) {
  const std::size_t count = robot.modes.size();
  std::vector<std::vector<bool>> together(count, std::vector<bool>(count, false));
  for (std::size_t i = 0; i < count; ++i) together[i][i] = true;
  for (const Switch& change : robot.switches)
    if (change.displacement == Pose{} && robot.modes[change.from].canTurn() &&
        robot.modes[change.to].canTurn())
      together[change.from][change.to] = together[change.to][change.from] = true;
  for (std::size_t k = 0; k < count; ++k)  // Warshall's closure
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        if (together[i][k] && together[k][j]) together[i][j] = true;
  of_mode.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::size_t>(std::find(together[i].begin(), together[i].end(), true) -
                                                together[i].begin());
    if (first == i) modes.emplace_back();
    of_mode[i] = first == i ? static_cast<GroupId>(modes.size() - 1) : of_mode[first];
    modes[of_mode[i]].push_back(static_cast<ModeId>(i));
  }
}

}  // namespace underway
