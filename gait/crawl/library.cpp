#include "gait/crawl/library.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace underway::gait {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargest_bytes = 1 << 20;

GaitExpected<std::string> contentOf(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size > kLargest_bytes)
    return tl::unexpected(GaitError{"gait file \"" + file.string() + "\" " +
                                    (error ? "cannot be read" : "is larger than 1 MB: it is no gait")});
  std::ifstream in(file, std::ios::binary);
  std::string text(size, '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(size)))
    return tl::unexpected(GaitError{"gait file \"" + file.string() + "\" cannot be read"});
  return text;
}

}  // namespace

std::vector<std::string> gaitNames(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

GaitExpected<GaitFile> readGait(const fs::path& folder, const std::string& gait) {
  std::error_code error;
  const std::vector<std::string> names = gaitNames(folder);
  const bool is_name = std::ranges::find(names, gait) != names.end();
  const fs::path file = is_name ? folder / (gait + ".json") : fs::path(gait);
  if (!fs::is_regular_file(file, error)) {
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    return tl::unexpected(
        GaitError{"gait \"" + gait + "\" is neither a file nor one that comes along; those are " + known});
  }
  const auto text = contentOf(file);
  if (!text) return tl::unexpected(text.error());
  return gaitFromJson(*text, file.lexically_normal().string());
}

}  // namespace underway::gait
