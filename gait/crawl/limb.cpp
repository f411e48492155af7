#include "gait/crawl/limb.hpp"

#include <algorithm>
#include <cmath>

namespace underway::gait {

LimbPoints pointsOf(const Limb& limb, const LimbAngles& angles) {
  const PlanePoint joint = limb.root + along(limb.m[0], angles.root);
  return {joint, joint + along(limb.m[1], angles.root + angles.joint)};
}

Feasible<LimbRoots> reach(const Limb& limb, PlanePoint end) {
  const auto [first_m, second_m] = limb.m;
  const PlanePoint span = end - limb.root;
  const double span_m = length(span);
  if (span_m > first_m + second_m || span_m < std::abs(first_m - second_m))
    return tl::unexpected(Infeasible{span_m, std::abs(first_m - second_m), first_m + second_m});
  const double cosine =
      (span_m * span_m - first_m * first_m - second_m * second_m) / (2.0 * first_m * second_m);
  const double joint = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double towards = std::atan2(span.z, span.x);
  const double inside = std::atan2(second_m * std::sin(joint), first_m + second_m * std::cos(joint));
  return LimbRoots{{towards - inside, joint}, {towards + inside, -joint}};
}

const LimbAngles& choose(const Limb& limb, const LimbRoots& roots) {
  return pointsOf(limb, roots.left).joint.z >= pointsOf(limb, roots.right).joint.z ? roots.left : roots.right;
}

}  // namespace underway::gait
