#pragma once

#include <string_view>
#include <vector>

#include "gait/crawl/gait_file.hpp"
#include "gait/crawl/optimise.hpp"

namespace underway::gait {

/// How a gait of the library came about: either the authors' own, or an optimum with these settings. The same
/// recipe makes the same gait again.
struct Recipe {
  CrawlGait from;  ///< name, times and lying; its push is the start, or the gait itself
  std::string about;
  double for_push_s_least = 1.0;
  double for_push_s_most = 10.0;
  bool is_optimised = true;
  Aim aim = Aim::kTorque;
  SearchSpace::Ends ends = SearchSpace::Ends::kFixed;
  PushLimits limits;
  DescentSettings search;
};

/// The library for NAO: what `underway gait library` makes.
[[nodiscard]] std::vector<Recipe> naoRecipes();

/// Optimised for the masses of NAO V5.0 with servos' internal force.
[[nodiscard]] GaitFile make(const Recipe& recipe, const SearchProgress& progress = {});

}  // namespace underway::gait
