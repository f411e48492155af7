#pragma once

#include <span>
#include <string>

#include "sim/physics/recording.hpp"
#include "sim/physics/scene.hpp"

namespace underway::physics {

/// The robot's contact shapes from its right side, one picture a sample below each other, as SVG: the floor,
/// a grid of 0.1 m, the obstacles, time and highest point. The left side's shapes are drawn lighter.
[[nodiscard]] std::string drawSide(const mjModel_& model, std::span<const Sample> samples);

/// `count` samples spread evenly over a recording, its first and last among them.
[[nodiscard]] std::vector<Sample> spread(const Recording& recording, std::size_t count);

}  // namespace underway::physics
