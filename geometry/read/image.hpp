#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/error.hpp"

namespace underway {

/// What the samples of an image mean.
struct ImageFormat {
  std::uint32_t width = 0;     ///< [pixels]
  std::uint32_t height = 0;    ///< [pixels]
  std::uint32_t channels = 1;  ///< 1: grey; 3: red, green, blue; 4: these and alpha
  std::uint32_t max = 255;     ///< the sample of full brightness, or of an opaque alpha
};

/// Gets an image row by row, from the top: width * channels samples, interleaved, 0..max. Images are never
/// held whole, so a large one costs no more than what the sink makes of it.
using RowSink =
    std::function<void(const ImageFormat&, std::uint32_t row, std::span<const std::uint16_t> samples)>;

/// The largest image that is read.
inline constexpr std::uint64_t kMostPixels = 100'000'000;
inline constexpr std::uint64_t kLongestSide = 100'000;                    ///< [pixels]
inline constexpr std::size_t kLargestImageFile = std::size_t{256} << 20;  ///< [bytes]

/// Whether the first bytes are those of an image, readable here or not. The name of a file is not asked.
[[nodiscard]] bool isImage(std::string_view bytes);

/// Refuses all but PGM and PNG, saying what it is and how to convert it. `file` is for the sentence.
[[nodiscard]] Expected<void> checkIsReadable(std::string_view bytes, const std::string& file);

/// Decodes a PGM or PNG. `file` is for sentences only. Errors: kInvalidMap: what it is and how to convert it,
/// if it is another format; what is wrong with it, if it is cut short or damaged. Rows sent before a fault
/// was found are void.
[[nodiscard]] Expected<void> decodeImage(std::string_view bytes, const std::string& file,
                                         const RowSink& sink);

/// Refuses images without pixels and with more than the limits above, as every decoder must before it
/// allocates.
[[nodiscard]] Expected<void> checkImageSize(std::uint64_t width, std::uint64_t height,
                                            const std::string& file);

}  // namespace underway
