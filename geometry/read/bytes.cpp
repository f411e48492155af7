#include "geometry/read/bytes.hpp"

#include <fstream>
#include <system_error>

namespace underway {

Expected<std::string> readBytes(const std::filesystem::path& file, std::size_t most_bytes, ErrorCode code) {
  const auto refuse = [&](const std::string& what) { return fail(code, file.string() + ": " + what); };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return refuse("no such file; check the path");
  if (!std::filesystem::is_regular_file(status)) return refuse("is not a file; give the path of a file");

  std::ifstream stream(file, std::ios::binary);
  if (!stream) return refuse("cannot be opened; check its permissions");
  const auto size = std::filesystem::file_size(file, error);
  if (error) return refuse("its size cannot be told: " + error.message());
  if (size > most_bytes)
    return refuse("holds " + std::to_string(size) + " bytes; at most " + std::to_string(most_bytes) +
                  " are read");

  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  // A file that another program just cut short gives less than it promised.
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) return refuse("cannot be read; check the disk it is on");
  return bytes;
}

}  // namespace underway
