#include "planner/roadmap_key.hpp"

#include <spdlog/fmt/fmt.h>

namespace underway {

RoadmapKey keyOf(const Checker& checker, const GrowthSettings& settings) {
  return {checker.world().hash(), hashOf(checker.robot()), settings.seed, settings.sites_per_m2};
}

std::optional<std::string> mismatch(const RoadmapKey& of_file, const RoadmapKey& here) {
  if (of_file.robot != here.robot)
    return fmt::format(
        "the roadmap is another robot's (hash {}, here {}): give the robot it was made for, or "
        "another file",
        of_file.robot, here.robot);
  if (of_file.seed != here.seed)
    return fmt::format("the roadmap was grown with seed {}, not {}: give that seed, or another file",
                       of_file.seed, here.seed);
  if (of_file.sites_per_m2 != here.sites_per_m2)
    return fmt::format(
        "the roadmap was grown for {} sites per square metre, not {}: give that setting, or another "
        "file",
        of_file.sites_per_m2, here.sites_per_m2);
  return std::nullopt;
}

}  // namespace underway
