#pragma once

#include <string>
#include <string_view>

#include "geometry/error.hpp"
#include "geometry/read/image.hpp"

namespace underway {

/// Decodes a PGM: P5 (binary) or P2 (text), maxval 1 to 65535, comments in the header. See image.hpp.
[[nodiscard]] Expected<void> decodePgm(std::string_view bytes, const std::string& file, const RowSink& sink);

}  // namespace underway
