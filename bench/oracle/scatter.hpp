#pragma once

#include <random>

#include "bench/oracle/shortcut.hpp"

namespace underway::bench {

/// The points of a stretch of a way, points between them, points shifted at random by about `shift_m`, and
/// bridges shifted, turned and slid: what a better way may lead through.
[[nodiscard]] Choices scattered(const Terrain& terrain, const Way& way, double shift_m,
                                std::mt19937_64& random);

/// The way's own points and points between them, nothing shifted: what a way has to be shortened first.
[[nodiscard]] Choices ownPoints(const Way& way, double apart_m);

}  // namespace underway::bench
