#include "gait/crawl/chain.hpp"

#include <spdlog/fmt/fmt.h>
#include <algorithm>
#include <cmath>

namespace underway::gait {
namespace {

/// Shin, thigh and back as one rigid link from ankle to shoulder, in the shin's frame.
PlanePoint ankleToShoulder(const LinkLengths& l, const Triplet& t) {
  const PlanePoint thigh = along(l[2], t.knee);
  const PlanePoint back = along(l[3], t.knee + t.hip);
  return {l[1] + thigh.x + back.x, thigh.z + back.z};  // (K1, -K2) of (4.14), (4.15)
}

double angleOf(PlanePoint v) { return std::atan2(v.z, v.x); }

/// Toe, ankle and shoulder, the leg as one link: what is left to solve.
struct Triangle {
  PlanePoint shoulder;
  double base = 0.0;  ///< theta2 of a foot that points at the shoulder
  double half = 0.0;  ///< what theta2 is off it, to either side
};

Feasible<Triangle> triangleOf(const LinkLengths& l, const Triplet& triplet, PlanePoint elbow) {
  const PlanePoint shoulder = elbow - along(l[4], triplet.alpha);
  const PlanePoint link = ankleToShoulder(l, triplet);
  const double foot_m = l[0];
  const double leg_m = length(link);
  const double span_m = length(shoulder);
  if (span_m > foot_m + leg_m || span_m < std::abs(foot_m - leg_m) || leg_m == 0.0)
    return tl::unexpected(Infeasible{span_m, std::abs(foot_m - leg_m), foot_m + leg_m});
  // (4.13): cos(theta2 - base), with base = atan2(K2, K1).
  const double cosine = (span_m * span_m - foot_m * foot_m - leg_m * leg_m) / (2.0 * foot_m * leg_m);
  return Triangle{shoulder, -angleOf(link), std::acos(std::clamp(cosine, -1.0, 1.0))};
}

/// theta1 and theta5 for a theta2: the rigid rest is turned until its shoulder lies where the arm needs it.
ChainAngles complete(const LinkLengths& l, const Triplet& t, PlanePoint shoulder, double ankle) {
  const PlanePoint link = ankleToShoulder(l, t);
  const PlanePoint turned{link.x * std::cos(ankle) - link.z * std::sin(ankle),
                          link.x * std::sin(ankle) + link.z * std::cos(ankle)};
  const PlanePoint unturned{l[0] + turned.x, turned.z};  // (K3, -K4) of (4.19), (4.20)
  const double toe = std::remainder(angleOf(shoulder) - angleOf(unturned), 2.0 * M_PI);
  return {{toe, ankle, t.knee, t.hip, t.alpha - (toe + ankle + t.knee + t.hip)}};
}

double lowest(const LinkLengths& lengths, const ChainAngles& angles) {
  const ChainPoints points = pointsOf(lengths, angles);
  return std::min({points[1].z, points[2].z, points[3].z, points[4].z});
}

}  // namespace

std::string Infeasible::sentence() const {
  return fmt::format("the links would have to span {:.1f} mm, and can span {:.1f} to {:.1f} mm",
                     1e3 * needs_m, 1e3 * least_m, 1e3 * most_m);
}

ChainPoints pointsOf(const LinkLengths& lengths, const ChainAngles& angles) {
  ChainPoints points;
  double direction = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    direction += angles.theta[i];
    points[i + 1] = points[i] + along(lengths[i], direction);
  }
  return points;
}

double closureError(const LinkLengths& lengths, const ChainAngles& angles, PlanePoint elbow) {
  return length(pointsOf(lengths, angles)[5] - elbow);
}

Feasible<ChainRoots> closeChain(const LinkLengths& lengths, const Triplet& triplet, PlanePoint elbow) {
  return triangleOf(lengths, triplet, elbow).map([&](const Triangle& triangle) {
    return ChainRoots{complete(lengths, triplet, triangle.shoulder, triangle.base - triangle.half),
                      complete(lengths, triplet, triangle.shoulder, triangle.base + triangle.half)};
  });
}

const ChainAngles& choose(const LinkLengths& lengths, const ChainRoots& roots) {
  return lowest(lengths, roots.ankle_up) >= lowest(lengths, roots.ankle_down) ? roots.ankle_up
                                                                              : roots.ankle_down;
}

Feasible<ChainAngles> pushPose(const LinkLengths& lengths, const Triplet& triplet, PlanePoint elbow) {
  const auto triangle = triangleOf(lengths, triplet, elbow);
  if (!triangle) return tl::unexpected(triangle.error());
  const ChainAngles up = complete(lengths, triplet, triangle->shoulder, triangle->base - triangle->half);
  if (lowest(lengths, up) >= 0.0) return up;
  return choose(lengths,
                {up, complete(lengths, triplet, triangle->shoulder, triangle->base + triangle->half)});
}

Feasible<Reach> reachOf(const LinkLengths& l, const Triplet& triplet) {
  const double leg_m = length(ankleToShoulder(l, triplet));
  const PlanePoint arm = along(l[4], triplet.alpha);
  const double least_m = std::abs(l[0] - leg_m);
  const double most_m = l[0] + leg_m;
  const double height_m = std::abs(arm.z);
  if (height_m > most_m) return tl::unexpected(Infeasible{height_m, least_m, most_m});
  // The elbow lies at x when the span, a right triangle with the shoulder's height, is within reach.
  const auto ahead = [&](double span_m) {
    return arm.x + std::sqrt(std::max(0.0, span_m * span_m - height_m * height_m));
  };
  return Reach{std::max(0.0, ahead(least_m)), ahead(most_m)};
}

}  // namespace underway::gait
