#pragma once

#include <vector>

#include "bench/oracle/keep.hpp"
#include "bench/oracle/lattice.hpp"
#include "planner/route.hpp"

namespace underway::bench {

/// A way that leads from beside the lattice to a node of it.
struct Spur {
  Lattice::Node node = 0;
  Route route;
  Cost cost;
};

/// A way along a rail and up at its end, into a gait that turns.
struct RailExit {
  Route route;
  Pose pose;
  GaitId gait = 0;
};

/// From a pose in a mode that does not turn: along each of its senses, a cell at a time as far as that is
/// free, and up wherever that is free. With `walker`, the gait that came down here, exits are left out that
/// it could walk to from the exit before.
[[nodiscard]] std::vector<RailExit> railExits(const Lattice& lattice, const Keep& keep, ModeId rail,
                                              const Pose& from, std::optional<GaitId> walker);

/// From a pose beside the lattice to nodes next to it: the nearest heading, then straight along the body's
/// axis if a node lies there, else along both axes to the four cells around. `is_backwards`: the way is meant
/// to be gone from its end to its beginning, so senses are those of the way back.
[[nodiscard]] std::vector<Spur> snapped(const Lattice& lattice, const Keep& keep, GaitId gait,
                                        const Pose& from, int heading, bool is_backwards);

/// All ways from a node that change gaits and come back to the lattice: down, along a rail and up, or one
/// switch between gaits that turn. Left out are those that are no better than walking on before going down,
/// or after coming up.
[[nodiscard]] std::vector<Spur> bridgesFrom(Lattice& lattice, Lattice::Node node);

}  // namespace underway::bench
