#include "gait/skeleton.hpp"

#include <algorithm>
#include <stdexcept>

namespace underway::gait {

std::vector<std::string> Skeleton::joints() const {
  std::vector<std::string> names;
  for (const Link& link : links)
    if (!link.joint.empty() && link.turns_with.empty()) names.push_back(link.joint);
  return names;
}

std::optional<std::size_t> Skeleton::findJoint(std::string_view joint) const {
  const auto found = std::ranges::find(links, joint, &Link::joint);
  if (joint.empty() || found == links.end()) return std::nullopt;
  return static_cast<std::size_t>(found - links.begin());
}

std::optional<std::size_t> Skeleton::findLink(std::string_view link) const {
  const auto found = std::ranges::find(links, link, &Link::name);
  if (found == links.end()) return std::nullopt;
  return static_cast<std::size_t>(found - links.begin());
}

double Skeleton::mass() const {
  double mass_kg = 0.0;
  for (const Link& link : links) mass_kg += link.mass_kg;
  return mass_kg;
}

Placements placementsOf(const Skeleton& skeleton, std::span<const double> angles_rad) {
  Placements placements;
  placements.reserve(skeleton.links.size());
  std::vector<double> angles(skeleton.links.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < skeleton.links.size(); ++i) {
    const Link& link = skeleton.links[i];
    if (!link.turns_with.empty()) {
      angles[i] = angles[*skeleton.findJoint(link.turns_with)];
    } else if (!link.joint.empty()) {
      if (next == angles_rad.size()) throw std::invalid_argument("a pose has too few angles");
      angles[i] = angles_rad[next++];
    }
    if (link.parent < 0) {
      placements.push_back(Eigen::Isometry3d::Identity());
      continue;
    }
    Eigen::Isometry3d placement = placements[static_cast<std::size_t>(link.parent)];
    placement.translate(link.offset);
    placement.rotate(Eigen::AngleAxisd(angles[i], link.axis));
    placements.push_back(placement);
  }
  if (next != angles_rad.size()) throw std::invalid_argument("a pose has too many angles");
  return placements;
}

Eigen::Vector3d massCenterOf(const Skeleton& skeleton, const Placements& placements) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < placements.size(); ++i)
    sum += skeleton.links[i].mass_kg * (placements[i] * skeleton.links[i].mass_center);
  return sum / skeleton.mass();
}

std::vector<Ball> ballsOf(const Skeleton& skeleton, const Placements& placements) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < placements.size(); ++i)
    for (const Ball& ball : skeleton.links[i].shape)
      balls.push_back({placements[i] * ball.center, ball.radius_m});
  return balls;
}

}  // namespace underway::gait
