#pragma once

#include <cstddef>
#include <cstdint>

namespace underway {

/// Says on standard error that the answer may have come from any of several servers, if there are several.
void complainOfRivals(std::size_t servers, std::uint32_t domain);

}  // namespace underway
