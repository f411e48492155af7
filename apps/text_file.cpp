#include "apps/text_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

namespace underway {
namespace {

namespace fs = std::filesystem;

std::string lastReason() { return std::generic_category().message(errno); }

/// `named`: the file that a failure speaks of.
Expected<void> writeInto(const fs::path& file, std::string_view text, const fs::path& named) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (stream) return {};
  return fail(ErrorCode::kInternal, "cannot write \"" + named.string() + "\": " + lastReason());
}

/// Not a pipe, a device or a link: what is written goes to where they lead.
bool mayBeReplaced(const fs::path& file) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(file, error).type();
  return type == fs::file_type::not_found || type == fs::file_type::regular;
}

}  // namespace

Expected<std::string> readText(const fs::path& file) {
  constexpr std::uintmax_t kLargest_bytes = 64U << 20U;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);  // an error for folders and devices too
  if (error)
    return fail(ErrorCode::kInvalidRequest, "cannot read \"" + file.string() + "\": " + error.message());
  if (size > kLargest_bytes)
    return fail(ErrorCode::kInvalidRequest,
                file.string() + " is larger than 64 MB; give one that underway wrote");
  std::string text(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
    return fail(ErrorCode::kInvalidRequest, "cannot read \"" + file.string() + "\": " + lastReason());
  return text;
}

Expected<void> writeText(const fs::path& file, std::string_view text) {
  return mayBeReplaced(file) ? replaceText(file, text) : writeInto(file, text, file);
}

Expected<void> replaceText(const fs::path& file, std::string_view text) {
  const fs::path fresh = file.string() + ".new" + std::to_string(getpid());
  std::error_code error;
  Expected<void> written = writeInto(fresh, text, file);
  if (written) {
    fs::rename(fresh, file, error);
    if (error)
      written = fail(ErrorCode::kInternal, "cannot write \"" + file.string() + "\": " + error.message());
  }
  if (!written) fs::remove(fresh, error);
  return written;
}

Expected<void> writeOutput(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return {};
  return fail(ErrorCode::kInternal, "cannot write to standard output: " + lastReason());
}

}  // namespace underway
