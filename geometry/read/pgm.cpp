#include "geometry/read/pgm.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

namespace underway {
namespace {

constexpr std::uint32_t kLargestMax = 65535;
constexpr std::string_view kSpace = " \t\n\v\f\r";

/// Reads a PGM's bytes from the front.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  [[nodiscard]] std::string_view rest() const { return rest_; }
  void skip(std::size_t count) { rest_.remove_prefix(count); }

  /// The next number, after white space and comments.
  [[nodiscard]] std::optional<std::uint32_t> number() {
    skipSpaceAndComments();
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) return std::nullopt;
    skip(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

 private:
  void skipSpaceAndComments() {
    for (;;) {
      const std::size_t text = rest_.find_first_not_of(kSpace);
      rest_.remove_prefix(std::min(text, rest_.size()));
      if (!rest_.starts_with('#')) return;
      rest_.remove_prefix(std::min(rest_.find_first_of("\n\r"), rest_.size()));
    }
  }

  std::string_view rest_;
};

/// One sample of a binary PGM, two bytes with the high one first if the maximum needs them.
std::uint16_t binarySample(std::string_view raster, std::size_t index, bool is_wide) {
  const auto byte = [&](std::size_t at) {
    return static_cast<unsigned>(static_cast<unsigned char>(raster[at]));
  };
  return static_cast<std::uint16_t>(is_wide ? byte(2 * index) << 8 | byte(2 * index + 1) : byte(index));
}

/// Reads the header up to the samples, and refuses what cannot be, before anything is allocated.
Expected<ImageFormat> readHeader(Reader& reader, bool is_binary, const std::string& file) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorCode::kInvalidMap, file + ": " + what);
  };
  const auto width = reader.number();
  const auto height = reader.number();
  const auto max = reader.number();
  if (!width || !height || !max)
    return refuse("the PGM header must give width, height and the largest sample");
  if (*max == 0 || *max > kLargestMax)
    return refuse("the PGM header's largest sample must be 1 to 65535, not " + std::to_string(*max));
  if (const auto size = checkImageSize(*width, *height, file); !size) return tl::unexpected(size.error());

  // As text, a sample takes a digit and the white space before it.
  const std::size_t samples = std::size_t{*width} * *height;
  const std::size_t needed = is_binary ? 1 + samples * (*max > 255 ? 2 : 1) : 2 * samples;
  if (reader.rest().size() < needed)
    return refuse("is cut short: " + std::to_string(*width) + " x " + std::to_string(*height) +
                  " pixels need " + std::to_string(needed) + " bytes after the header, found " +
                  std::to_string(reader.rest().size()));
  if (kSpace.find(reader.rest().front()) == std::string_view::npos)
    return refuse("white space must follow the PGM header");
  reader.skip(1);  // just this one: in a binary PGM the next byte is a sample, whatever it looks like
  return ImageFormat{*width, *height, 1, *max};
}

}  // namespace

Expected<void> decodePgm(std::string_view bytes, const std::string& file, const RowSink& sink) {
  const bool is_binary = bytes.starts_with("P5");
  Reader reader(bytes);
  reader.skip(2);
  const auto format = readHeader(reader, is_binary, file);
  if (!format) return tl::unexpected(format.error());

  const std::string_view raster = reader.rest();
  std::vector<std::uint16_t> row(format->width);
  for (std::uint32_t y = 0; y < format->height; ++y) {
    for (std::uint32_t x = 0; x < format->width; ++x) {
      const auto sample = is_binary
                              ? binarySample(raster, std::size_t{y} * format->width + x, format->max > 255)
                              : reader.number();
      const auto refuse = [&](const std::string& what) {
        const std::string where = file + ": pixel " + std::to_string(x) + " of row " + std::to_string(y);
        return fail(ErrorCode::kInvalidMap, where + " is " + what);
      };
      if (!sample) return refuse("not a number, or the file is cut short there");
      if (*sample > format->max)
        return refuse(std::to_string(*sample) + ", above the header's largest sample " +
                      std::to_string(format->max));
      row[x] = static_cast<std::uint16_t>(*sample);
    }
    sink(*format, y, row);
  }
  return {};
}

}  // namespace underway
