#include "gait/crawl/crawler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway::gait {

std::string_view name(CrawlJoint joint) {
  constexpr std::array<std::string_view, kCrawlJoints> kNames{
      "ankle", "knee", "hip", "shoulder pitch", "shoulder roll", "elbow yaw", "elbow roll"};
  return kNames.at(joint);
}

double MappedJoint::lower() const { return std::min(toCrawl(limits.lower_rad), toCrawl(limits.upper_rad)); }
double MappedJoint::upper() const { return std::max(toCrawl(limits.lower_rad), toCrawl(limits.upper_rad)); }

LinkLengths Crawler::lengths(double spread_m) const {
  return {links_m[0], links_m[1], links_m[2], links_m[3], arm.projected(spread_m)};
}

double Crawler::mostBend() const {
  return std::min(-sides[0][kElbowRoll].lower(), -sides[1][kElbowRoll].lower());
}

std::vector<std::string> Crawler::joints() const {
  std::vector<std::string> names;
  for (const auto& side : sides)
    for (const MappedJoint& joint : side) names.push_back(joint.name);
  if (head) names.push_back(head->name);
  for (const HeldJoint& joint : held) names.push_back(joint.name);
  return names;
}

SideShape shapeOf(const ChainAngles& chain, double spread_m) {
  const double back = chain.back();
  return {chain.ankle(), chain.knee(), chain.hip(), back, back + chain.shoulder(), spread_m, 0.0};
}

Feasible<SideAngles> anglesOf(const Crawler& crawler, const SideShape& shape) {
  const auto roll = shoulderRollFor(crawler.arm, shape.spread_m);
  if (!roll) return tl::unexpected(roll.error());
  const double tilt = shape.back - shape.rise;
  const Eigen::Vector3d forearm{std::sin(tilt), 0.0, std::cos(tilt)};  // in the torso's frame
  const double pitch = -0.5 * std::numbers::pi - (shape.alpha - shape.back);
  const ArmAngles arm = pointForearm({pitch, *roll, 0.0, 0.0}, forearm, crawler.mostBend());
  return SideAngles{shape.ankle,       shape.knee,    shape.hip,     arm.shoulder_pitch,
                    arm.shoulder_roll, arm.elbow_yaw, arm.elbow_roll};
}

}  // namespace underway::gait
