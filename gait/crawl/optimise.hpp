#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "gait/crawl/search_space.hpp"

namespace underway::gait {

/// What is minimised: a function of a point of the search space.
using Objective = std::function<double(const std::vector<double>& point)>;

/// Called as the search goes on: share done 0..1, and the best cost so far.
using SearchProgress = std::function<void(double share, double best)>;

struct Found {
  std::vector<double> point;
  double cost = 0.0;
  int evaluations = 0;
  /// After each generation, or each hundred evaluations: best cost so far, and the mean of the last ones.
  struct Step {
    double best;
    double mean;
  };
  std::vector<Step> history;
};

/// A genetic algorithm as the thesis used it (4.3.3; MATLAB's defaults): the two best live on, parents are
/// drawn by their rank, children take each number from either parent or are mutated by a normal step that
/// shrinks. The same seed gives the same answer.
struct GeneticSettings {
  int population = 100;
  int generations = 72;
  std::uint64_t seed = 1;
};
[[nodiscard]] Found searchGenetic(const Objective& objective, const SearchSpace& space,
                                  const GeneticSettings& settings, const SearchProgress& progress = {});

/// The better one: NLopt's controlled random search over the whole box, then its subplex search from the best
/// point. The same seed gives the same answer; two searches at once in one thread would share NLopt's random
/// numbers, so run them one after the other.
struct DescentSettings {
  int evaluations = 7200;  ///< at most
  std::uint64_t seed = 1;
};
[[nodiscard]] Found searchDescent(const Objective& objective, const SearchSpace& space,
                                  const DescentSettings& settings, const SearchProgress& progress = {});

/// The aim's cost, and 1e4 for every unit of violation: any step into what is allowed pays.
[[nodiscard]] Objective objectiveFor(const Crawler& crawler, const ChainMasses& masses,
                                     const SearchSpace& space, const PushSetting& setting, Aim aim);

}  // namespace underway::gait
