#include "local/start.hpp"

#include <cmath>
#include <numbers>

namespace underway {

Pose startFrom(const Checker& checker, ModeId mode, const Pose& believed) {
  constexpr int kDirections = 16;
  const double margin_m = checker.robot().margin_m;
  const auto keeps = [&](const Pose& pose) { return checker.isFree(stay(mode, pose), margin_m); };
  const auto clearance = [&](const Pose& pose) {
    return checker.isInBounds(stay(mode, pose)) ? checker.clearance(stay(mode, pose), margin_m) : 0.0;
  };
  if (keeps(believed)) return believed;
  Pose best = believed;
  double most_m = clearance(believed);
  for (const double off_m : {0.004, 0.008, 0.012, 0.016, 0.02})
    for (const double turned_rad : {0.0, -0.025, 0.025, -0.05, 0.05})
      for (int i = 0; i < kDirections; ++i) {
        const double direction = 2.0 * std::numbers::pi * i / kDirections;
        const Pose near{believed.x + off_m * std::cos(direction), believed.y + off_m * std::sin(direction),
                        normalizedAngle(believed.yaw + turned_rad)};
        if (keeps(near)) return near;
        if (const double its_m = clearance(near); its_m > most_m) best = near, most_m = its_m;
      }
  return best;
}

}  // namespace underway
