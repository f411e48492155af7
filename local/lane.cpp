#include "local/lane.hpp"

#include <cmath>
#include <numbers>

namespace underway {

OnLane onLane(const Motion& translation, const Pose& at) {
  const double direction = translation.from.yaw + angleOf(translation.sense);
  const double dx = at.x - translation.from.x;
  const double dy = at.y - translation.from.y;
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  return {c * dx + s * dy, c * dy - s * dx, normalizedAngle(at.yaw - translation.from.yaw)};
}

Motion shifted(const Motion& translation, double left_m) {
  const double left = translation.from.yaw + angleOf(translation.sense) + 0.5 * std::numbers::pi;
  Motion beside = translation;
  for (Pose* end : {&beside.from, &beside.to}) {
    end->x += left_m * std::cos(left);
    end->y += left_m * std::sin(left);
  }
  return beside;
}

Point pointAlong(const Motion& translation, double along_m) {
  const double direction = translation.from.yaw + angleOf(translation.sense);
  return {translation.from.x + along_m * std::cos(direction),
          translation.from.y + along_m * std::sin(direction)};
}

}  // namespace underway
