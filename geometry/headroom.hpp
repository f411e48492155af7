#pragma once

#include <optional>

#include "geometry/layer.hpp"

namespace underway {

/// The smallest vertical gap [m] between a body's top and what hangs above it (Layer::hangingAbove that top);
/// empty when nothing does.
[[nodiscard]] std::optional<double> headroomBelow(const Layer& hanging, const Prism& body);

/// The same over a turn about the body frame's origin by a signed angle [rad]. Exact below upright boxes;
/// below tilted ones up to what they rise within 0.5 mm.
[[nodiscard]] std::optional<double> headroomBelow(const Layer& hanging, const Prism& body, double angle_rad);

}  // namespace underway
