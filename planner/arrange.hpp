#pragma once

#include <span>

#include "planner/legs.hpp"
#include "planner/roadmap.hpp"

namespace underway {

/// Works out all that follows from a roadmap's places, links, ways and crossings: where the robot turns
/// freely, the crossings by the place they lead to, the indexes of places, the counts. `legs`: by group, of
/// the world the ways are free in.
///
/// Precondition: links are ordered by the place they leave, and places know theirs.
void arrange(Roadmap& roadmap, std::span<const Legs> legs);

}  // namespace underway
