#include "sim/sensors.hpp"

#include <algorithm>

namespace underway::sim {
namespace {

constexpr LidarSettings kWaist{};
constexpr double kMostLook_rad = 2.08;  // NAO's HeadYaw

/// A depth camera, as if its points were seen from above: nearest of all heights up to the standing body's.
LidarSettings depthFor(const DepthSense& sense, const Robot& robot) {
  LidarSettings settings;
  settings.beams = depthBeamsOf(sense.field_rad);
  settings.heights_m = {0.02, robot.modes.front().body_m.z.max};
  settings.nearest_m = 0.02;
  settings.farthest_m = sense.farthest_m;
  return settings;
}

LidarSettings lidarFor(const LidarSense& sense) {
  LidarSettings settings = kWaist;
  settings.heights_m = {sense.height_m, sense.height_m};
  return settings;
}

LidarSettings noisier(LidarSettings settings, double scale) {
  settings.sigma_m *= scale;
  settings.sigma_share *= scale;
  return settings;
}

}  // namespace

Flaws Flaws::times(double factor) const {
  Flaws more = *this;
  for (double* noise : {&more.pose_sigma_m, &more.pose_sigma_rad, &more.stroke_sigma, &more.drift_rad_per_m,
                        &more.drift_sigma_rad_per_m, &more.lidar_scale})
    *noise *= factor;
  return more;
}

Sensors::Sensors(const World& truth, std::shared_ptr<const Robot> robot, const Flaws& flaws,
                 const Pose& start)
    : robot_(std::move(robot)), flaws_(flaws) {
  const SensesOfRobot& senses = robot_->senses;
  if (senses.waist) waist_.emplace(truth, noisier(lidarFor(*senses.waist), flaws.lidar_scale));
  if (senses.head) head_.emplace(truth, noisier(lidarFor(*senses.head), flaws.lidar_scale));
  if (senses.depth) depth_.emplace(truth, noisier(depthFor(*senses.depth, *robot_), flaws.lidar_scale));
  past_.assign(static_cast<std::size_t>(flaws.late_ticks) + 1, start);
}

void Sensors::sense(const Bearing& bearing, Senses& senses, std::mt19937_64& random) {
  std::normal_distribution<double> unit;
  const Pose& at = bearing.pose;
  senses.now_s = bearing.now_s;
  const auto& lidar = bearing.is_upright ? waist_ : head_;
  if (lidar) {
    lidar->look(at, scan_, random);
    scan_.stamp_s = bearing.now_s;
    senses.scan = &scan_;
  }
  if (depth_ && bearing.is_upright) {
    depth_->look({at.x, at.y, at.yaw + look_rad_}, depth_scan_, random);
    depth_scan_.beams.first_rad += look_rad_;
    depth_scan_.stamp_s = bearing.now_s;
    senses.depth = &depth_scan_;
  }
  senses.heading_rad = normalizedAngle(bearing.heading_rad + flaws_.pose_sigma_rad * unit(random));
  if (!lidar || !bearing.can_localise) return;
  const Pose& then = past_.front();
  senses.pose = {bearing.now_s - kTick_s * flaws_.late_ticks,
                 {then.x + flaws_.pose_sigma_m * unit(random), then.y + flaws_.pose_sigma_m * unit(random),
                  normalizedAngle(then.yaw + flaws_.pose_sigma_rad * unit(random))}};
}

void Sensors::remember(const Pose& pose) {
  std::rotate(past_.begin(), past_.begin() + 1, past_.end());
  past_.back() = pose;
}

void Sensors::look(double rad) { look_rad_ = std::clamp(rad, -kMostLook_rad, kMostLook_rad); }

}  // namespace underway::sim
