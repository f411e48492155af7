#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "geometry/error.hpp"

namespace underway {

/// The whole content of a regular file of at most `most_bytes`. Never waits on a pipe or a device.
/// Errors: `code`, one sentence with the file.
[[nodiscard]] Expected<std::string> readBytes(const std::filesystem::path& file, std::size_t most_bytes,
                                              ErrorCode code);

}  // namespace underway
