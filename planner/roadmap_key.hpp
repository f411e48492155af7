#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/checker.hpp"
#include "planner/settings.hpp"

namespace underway {

/// What a roadmap was made for: with the number of its batches, all that fixes it.
struct RoadmapKey {
  std::string world;  ///< World::hash(): 16 hex digits
  std::string robot;  ///< hashOf(robot): 16 hex digits
  std::uint64_t seed = 0;
  double sites_per_m2 = 0.0;  ///< [1/m2]
  bool operator==(const RoadmapKey&) const = default;

  static constexpr std::size_t kHashDigits = 16;
};
[[nodiscard]] RoadmapKey keyOf(const Checker& checker, const GrowthSettings& settings);

/// Why a roadmap made for one key cannot serve under another: a sentence that says what differs and what to
/// do. Empty when nothing does, or the world alone: its ways can be looked at again.
[[nodiscard]] std::optional<std::string> mismatch(const RoadmapKey& of_file, const RoadmapKey& here);

}  // namespace underway
