#pragma once

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "sim/physics/simulation.hpp"

namespace underway::physics {

inline const std::filesystem::path kRobot = std::filesystem::path(UNDERWAY_SOURCE_DIR) / "robots" / "nao.xml";

/// NAO in a scene; throws where its model cannot be read.
inline Simulation nao(const Conditions& conditions, const Scene& scene = {}) {
  auto simulation = Simulation::make(kRobot, scene, conditions);
  if (!simulation) throw std::runtime_error(simulation.error().message);
  return std::move(*simulation);
}

}  // namespace underway::physics
