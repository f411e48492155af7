#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/error.hpp"

namespace underway::bench {

/// The numbers of some columns of a comma-separated file, row by row, in the order asked for. The first line
/// names the columns. Errors: kInvalidMap, with file, line and column.
[[nodiscard]] Expected<std::vector<std::vector<double>>> readNumbers(const std::filesystem::path& file,
                                                                     std::span<const std::string> columns);

}  // namespace underway::bench
