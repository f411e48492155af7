#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/error.hpp"

namespace underway {

/// The whole of a file. Errors: kInvalidRequest, one sentence; files above 64 MB are refused.
[[nodiscard]] Expected<std::string> readText(const std::filesystem::path& file);

/// All at once where the file is a plain one or a new one: a full disk leaves the old one, never half of the
/// new one. Errors: kInternal, one sentence with the file and the system's reason.
[[nodiscard]] Expected<void> writeText(const std::filesystem::path& file, std::string_view text);
/// The same of any file: whoever reads it meanwhile, or after a crash, sees the old one or the new one.
[[nodiscard]] Expected<void> replaceText(const std::filesystem::path& file, std::string_view text);
/// To standard output, which may be a full disk or a closed pipe. Errors: kInternal.
[[nodiscard]] Expected<void> writeOutput(std::string_view text);

}  // namespace underway
