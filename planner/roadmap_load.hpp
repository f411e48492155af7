#pragma once

#include <string_view>

#include "planner/repair.hpp"
#include "planner/roadmap_file.hpp"

namespace underway {

/// A roadmap that came from a file and that the present world agrees with.
struct Loaded {
  bool is_of_this_world =
      true;  ///< else it was made for another, and its ways are those that are free in this one
  std::uint32_t batches = 0;  ///< that it holds
  Repair repair;              ///< what was looked at, and what has closed and opened in this world
};

struct LoadedRoadmap {
  Roadmap roadmap;
  Loaded how;
};

/// Reads a roadmap and looks at every way of it anew: what is free is the checker's word, never the file's.
/// `stances` are of the checker. Errors: kInvalidRequest with a sentence, for what fromBytes refuses, for a
/// file made for this world that calls a way free which is not, or the reverse, and for a file of a world so
/// different that less than half of its free ways are left: growing anew covers this one better.
[[nodiscard]] Expected<LoadedRoadmap> load(std::string_view bytes, const RoadmapKey& here,
                                           const Stances& stances, const Checker& checker);

}  // namespace underway
