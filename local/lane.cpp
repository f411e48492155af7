#include "local/lane.hpp"

#include <cmath>

namespace underway {

OnLane onLane(const Motion& translation, const Pose& at) {
  const double direction = translation.from.yaw + angleOf(translation.sense);
  const double dx = at.x - translation.from.x;
  const double dy = at.y - translation.from.y;
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  return {c * dx + s * dy, c * dy - s * dx, normalizedAngle(at.yaw - translation.from.yaw)};
}

Point pointAlong(const Motion& translation, double along_m) {
  const double direction = translation.from.yaw + angleOf(translation.sense);
  return {translation.from.x + along_m * std::cos(direction),
          translation.from.y + along_m * std::sin(direction)};
}

}  // namespace underway
