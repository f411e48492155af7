#include "sim/physics/recording.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace underway::physics {

BodyBox sweptBox(const Recording& recording) {
  if (recording.samples.empty()) throw std::invalid_argument("a recording without samples sweeps no box");
  BodyBox swept = recording.samples.front().box;
  for (const Sample& sample : recording.samples)
    swept = {hull(swept.x, sample.box.x), hull(swept.y, sample.box.y), hull(swept.z, sample.box.z)};
  return swept;
}

double torqueCost(const Recording& recording, const std::vector<double>& weights) {
  static const std::array<std::string, 4> kJoints{"AnklePitch", "KneePitch", "HipPitch", "ShoulderPitch"};
  double sum = 0.0;
  for (std::size_t i = 0; i < kJoints.size(); ++i)
    sum += weights.at(i) * 0.5 *
           (recording.efforts.at("L" + kJoints[i]).square_nm2s +
            recording.efforts.at("R" + kJoints[i]).square_nm2s);
  return sum;
}

Pose relative(const Pose& from, const Pose& to) {
  const double c = std::cos(from.yaw);
  const double s = std::sin(from.yaw);
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  return {c * x + s * y, -s * x + c * y, normalizedAngle(to.yaw - from.yaw)};
}

}  // namespace underway::physics
