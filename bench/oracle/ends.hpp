#pragma once

#include <vector>

#include "bench/oracle/bridges.hpp"

namespace underway::bench {

/// The ways from a request's start to the lattice: straight on for a while to any side, or along a rail and
/// up; then a turn, then to a node nearby.
[[nodiscard]] std::vector<Spur> waysFromStart(const Lattice& lattice, const Keep& keep,
                                              const Request& request);

/// The ways from the lattice to a request's goal. Of each, `node` is where it leaves the lattice.
[[nodiscard]] std::vector<Spur> waysToGoal(const Lattice& lattice, const Keep& keep, const Request& request);

}  // namespace underway::bench
