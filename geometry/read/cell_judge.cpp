#include "geometry/read/cell_judge.hpp"

#include <cmath>

namespace underway {
namespace {

/// What a mean of `sum` out of `full` means. The mean is never formed, so that p is rounded once only and a
/// pixel that lies on a threshold is found to.
Cell cellOf(std::uint32_t sum, std::uint32_t full, const MapServerSettings& settings) {
  double p = static_cast<double>(settings.negate ? sum : full - sum) / full;
  if (settings.mode == PixelMode::kRaw) {
    const double per_cent = std::round(255.0 * sum / full);
    if (per_cent > 100.0) return Cell::kUnknown;
    p = per_cent / 100.0;
  }
  if (p > settings.occupied_thresh) return Cell::kOccupied;
  if (p < settings.free_thresh) return Cell::kFree;
  return Cell::kUnknown;
}

}  // namespace

CellJudge::CellJudge(const MapServerSettings& settings, const ImageFormat& format)
    : counting_channels_(format.channels), transparent_is_unknown_(false), opaque_(format.max) {
  if (format.channels == 4 && settings.mode != PixelMode::kTrinary) {
    counting_channels_ = 3;
    transparent_is_unknown_ = settings.mode == PixelMode::kScale;
  }
  const auto full = static_cast<std::uint32_t>(format.max * counting_channels_);
  by_sum_.reserve(std::size_t{full} + 1);
  for (std::uint32_t sum = 0; sum <= full; ++sum) by_sum_.push_back(cellOf(sum, full, settings));
}

Cell CellJudge::operator()(std::span<const std::uint16_t> pixel) const {
  if (transparent_is_unknown_ && pixel.back() < opaque_) return Cell::kUnknown;
  std::uint32_t sum = 0;
  for (const std::uint16_t sample : pixel.first(counting_channels_)) sum += sample;
  return by_sum_[sum];
}

}  // namespace underway
