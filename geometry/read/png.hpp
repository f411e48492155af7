#pragma once

#include <string>
#include <string_view>

#include "geometry/error.hpp"
#include "geometry/read/image.hpp"

namespace underway {

/// Decodes a PNG of any colour type, 1 to 16 bit, interlaced or not. Grey without alpha comes as 1 channel,
/// all else as 3, or 4 where the file has an alpha or a transparent colour. No gamma is applied. See
/// image.hpp.
[[nodiscard]] Expected<void> decodePng(std::string_view bytes, const std::string& file, const RowSink& sink);

}  // namespace underway
