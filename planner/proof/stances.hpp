#pragma once

#include <vector>

#include "geometry/checker.hpp"
#include "geometry/layer.hpp"
#include "planner/proof/core.hpp"

namespace underway::proof {

/// A body, or a switch's box, and what it must not touch.
struct Shape {
  Footprint footprint;
  const Layer* seen;  ///< the checker's
};

/// A switch that leads out of a stance.
struct Exit {
  std::size_t of_switch;  ///< index into the robot's switches
  std::size_t shape;      ///< index into Stances::shapes
  std::uint32_t to;       ///< the stance it leads to
  Pose displacement;      ///< in the body frame before it
};

/// Modes that have one body and change into each other where they stand: together they move in all senses
/// that one of them has.
struct Stance {
  std::vector<ModeId> modes;
  std::size_t shape = 0;  ///< index into Stances::shapes
  bool can_turn = false;
  std::vector<Sense> senses;
  std::vector<Exit> exits;
};

/// A robot's modes, as far as they differ in where the body may be.
struct Stances {
  std::vector<Shape> shapes;
  std::vector<Stance> all;
  std::vector<std::uint32_t> of_mode;  ///< index into `all`
};

/// `margin_m` is kept from every obstacle. The checker must outlive the result.
[[nodiscard]] Stances stancesOf(const Checker& checker, double margin_m);

}  // namespace underway::proof
