#pragma once

#include "bench/oracle/way.hpp"

namespace underway::bench {

struct RefineSettings {
  int rounds = 60;              ///< at most, of ever smaller shifts
  std::size_t window = 8;       ///< legs looked at together
  double first_shift_m = 0.30;  ///< of a point, standard deviation
  double last_shift_m = 0.001;  ///< in the last round
  unsigned long seed = 1;
};

/// A route's shortcuts, exhaustively: all pairs of its points, points between them and randomly shifted
/// points, joined by turn, translation and turn in every mode and sense, and bridges shifted, turned and
/// slid; again and again with ever smaller shifts. Costs no more than the route, and is free wherever that
/// is. `route` need not hold the switches between companions; the result does, and is chained bit for bit.
[[nodiscard]] Route refined(const Terrain& terrain, const Request& request, const Route& route,
                            const RefineSettings& settings = {});

}  // namespace underway::bench
