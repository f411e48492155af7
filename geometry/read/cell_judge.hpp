#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/grid.hpp"
#include "geometry/read/image.hpp"
#include "geometry/read/map_server.hpp"

namespace underway {

/// Says what a pixel of a map_server image means. https://wiki.ros.org/map_server, 'Value Interpretation':
/// with the mean v of the channels, 0..max, the probability of an obstacle is p = (max - v) / max, or v / max
/// if negated. Occupied if p > occupied_thresh, free if p < free_thresh (both strictly), else unknown.
/// - trinary: alpha is a channel like the others, as it always was in map_server.
/// - scale: alpha is none; any transparency makes a cell unknown. What map_server grades between the
/// thresholds is
///   neither known to be free nor to be occupied: unknown.
/// - raw: alpha is none; v, brought to 0..255 and rounded, is the occupancy in per cent, and unknown above
/// 100. It is
///   p that is held against the thresholds. As documented, raw means the pixel itself: negate plays no part.
class CellJudge {
 public:
  CellJudge(const MapServerSettings& settings, const ImageFormat& format);

  /// `pixel` holds the format's channels.
  [[nodiscard]] Cell operator()(std::span<const std::uint16_t> pixel) const;

 private:
  std::vector<Cell> by_sum_;       ///< what each sum of the channels that count means
  std::size_t counting_channels_;  ///< of a pixel, from its front
  bool transparent_is_unknown_;
  std::uint32_t opaque_;
};

}  // namespace underway
