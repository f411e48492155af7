#pragma once

#include <string>

#include "geometry/world.hpp"
#include "planner/plan_document.hpp"
#include "planner/roadmap.hpp"

namespace underway {

/// What a picture shows. World and robot are seen from above; the rest is drawn where it is given.
struct Picture {
  const World& world;
  const Robot& robot;
  const Roadmap* roadmap = nullptr;        ///< as thin lines; thinned out when there are many
  const PlanDocument* document = nullptr;  ///< a plan, or what blocks it
};

/// A picture as SVG: obstacles by whether they block every mode, only some, or none; bodies swept, way and
/// switches of the plan coloured by mode; start and goals (those it does not lead to, paler), legend, totals,
/// and a scale bar. Obstacles are shown whole, not cut to a mode's slab. Its size grows with the obstacles,
/// some 20 bytes each.
[[nodiscard]] std::string drawSvg(const Picture& picture);

}  // namespace underway
