#pragma once

#include <array>
#include <string>
#include <string_view>

#include "apps/draw_svg.hpp"
#include "apps/svg.hpp"

namespace underway {

/// Which modes an obstacle blocks, judged by its whole height.
enum class Blocks { kEvery, kSome, kNone };
[[nodiscard]] Blocks blocksOf(const Obstacle& obstacle, const World& world, const Robot& robot);
/// Whether the obstacle reaches into what the mode sees.
[[nodiscard]] bool isSeenBy(const Obstacle& obstacle, const Mode& mode, double floor_z_m);

/// Easy to tell apart for everyone (Okabe and Ito), by priority.
inline constexpr std::array<std::string_view, kMaxModes> kModeColours{"#0072b2", "#009e73", "#d55e00",
                                                                      "#aa4499", "#b8860b"};
[[nodiscard]] constexpr std::string_view colourOf(ModeId mode) { return kModeColours[mode % kMaxModes]; }

/// How the classes of obstacles are painted, in the map and in the legend.
[[nodiscard]] std::string_view paintOf(Blocks blocks);

// Each draws one layer, from the bottom up; empty when there is nothing to draw.
[[nodiscard]] std::string drawFloor(const Picture& picture, const View& view);
[[nodiscard]] std::string drawRoadmap(const Picture& picture, const View& view);
[[nodiscard]] std::string drawObstacles(const Picture& picture, const View& view);
/// The plan's bodies, way, switches, start and goal; on a failure start, goal, and what is in the way.
[[nodiscard]] std::string drawPlan(const Picture& picture, const View& view);

/// Title, totals, modes, kinds of obstacles: what the picture means, in a column of `width_px` from `at_px`.
[[nodiscard]] std::string drawLegend(const Picture& picture, Point at_px, double width_px);

}  // namespace underway
