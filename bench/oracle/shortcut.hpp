#pragma once

#include <vector>

#include "bench/oracle/way.hpp"

namespace underway::bench {

/// Places in the order they may be passed, and the bridges between some of them.
struct Choices {
  struct Bridge {
    std::size_t from = 0;  ///< index into spots, less than `to`
    std::size_t to = 0;
    Leg leg;
  };
  std::vector<Spot> spots;  ///< the first is where the way begins, the last where it ends
  std::vector<Bridge> bridges;
  double start_yaw = 0.0;
  std::optional<double> goal_yaw;  ///< empty: any
};

/// The cheapest way from the first place to the last through any of the others in order: from each to each
/// after it by a turn and a translation to any of the body's sides, or over a bridge. Exactly checked. Empty
/// if none costs less than `limit`.
[[nodiscard]] std::optional<Way> cheapest(const Terrain& terrain, const Choices& choices, Cost limit);

}  // namespace underway::bench
