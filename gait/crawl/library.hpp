#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gait/crawl/gait_file.hpp"

namespace underway::gait {

/// The gaits that come along: one JSON file each, in a folder (gaits/).

/// Names, in alphabetical order; none if there is no such folder.
[[nodiscard]] std::vector<std::string> gaitNames(const std::filesystem::path& folder);

/// A gait by its name in the folder, or by its own file. Errors: it is neither, and which there are; the file
/// cannot be read or says something wrong, and where.
[[nodiscard]] GaitExpected<GaitFile> readGait(const std::filesystem::path& folder, const std::string& gait);

}  // namespace underway::gait
