#include "geometry/read/png.hpp"

#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <vector>

namespace underway {
namespace {

/// A chunk of text or colour profile larger than this is dropped before it is unpacked.
constexpr png_alloc_size_t kLargestChunk = 1 << 20;
/// No deflate stream unpacks to more than this many times its size.
constexpr std::uint64_t kLargestDeflateRatio = 1032;
/// An interlaced image has to be held whole while it is decoded.
constexpr std::uint64_t kLargestInterlaced = std::uint64_t{256} << 20;

/// One libpng decoder over bytes in memory.
class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : rest_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }
  [[nodiscard]] const char* message() const { return message_; }

  /// Runs a step with libpng's errors caught; false if it failed. libpng leaves a failed step by longjmp,
  /// which runs no destructors: a step must hold no object that has one, and call nothing that does.
  template <class Step>
  [[nodiscard]] bool attempt(Step step) {
    if (info_ == nullptr) return false;
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    step();
    return true;
  }

  void start() {
    png_set_read_fn(png_, this, onRead);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // checkImageSize says it better
    png_set_chunk_malloc_max(png_, kLargestChunk);
    png_read_info(png_, info_);
  }

 private:
  static Decoder& of(png_voidp pointer) { return *static_cast<Decoder*>(pointer); }
  [[noreturn]] static void onError(png_structp png, png_const_charp message) {
    char* kept = of(png_get_error_ptr(png)).message_;
    std::strncpy(kept, message, sizeof(message_) - 1);
    png_longjmp(png, 1);
  }
  static void onWarning(png_structp, png_const_charp) {}
  static void onRead(png_structp png, png_bytep target, std::size_t count) {
    std::string_view& rest = of(png_get_io_ptr(png)).rest_;
    if (count > rest.size()) png_error(png, "the file is cut short");
    std::memcpy(target, rest.data(), count);
    rest.remove_prefix(count);
  }

  std::string_view rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char message_[96] = "libpng found no memory";
};

/// Asks libpng for whole samples of 8 or 16 bit, in this machine's byte order, as grey, RGB or RGBA. Returns
/// in how many passes over the rows it gives them: more than one if the image is interlaced.
int normalise(png_structp png, png_infop info) {
  const int type = png_get_color_type(png, info);
  const bool is_transparent = png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  png_set_expand(png);
  // map_server's mean over the channels counts a grey with alpha as three equal colours and the alpha.
  if (type == PNG_COLOR_TYPE_GRAY_ALPHA || (type == PNG_COLOR_TYPE_GRAY && is_transparent))
    png_set_gray_to_rgb(png);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return passes;
}

/// Samples of 8 or 16 bit as they lie in libpng's row.
void widen(std::span<const png_byte> bytes, std::span<std::uint16_t> samples) {
  if (bytes.size() == samples.size())
    std::copy(bytes.begin(), bytes.end(), samples.begin());
  else
    std::memcpy(samples.data(), bytes.data(), bytes.size());
}

tl::unexpected<Error> refuse(const std::string& file, const std::string& what) {
  return fail(ErrorCode::kInvalidMap, file + ": " + what);
}

tl::unexpected<Error> refuseDamaged(const std::string& file, const Decoder& decoder) {
  return refuse(file, std::string("is a damaged PNG image: ") + decoder.message());
}

/// Refuses sizes that are beyond our limits, and beyond what so few bytes can hold.
Expected<void> checkClaims(const Decoder& decoder, std::size_t file_size, const std::string& file) {
  const std::uint64_t width = png_get_image_width(decoder.png(), decoder.info());
  const std::uint64_t height = png_get_image_height(decoder.png(), decoder.info());
  if (const auto size = checkImageSize(width, height, file); !size) return size;
  if (height * png_get_rowbytes(decoder.png(), decoder.info()) > kLargestDeflateRatio * file_size)
    return refuse(file, "is cut short: " + std::to_string(width) + " x " + std::to_string(height) +
                            " pixels cannot be packed into " + std::to_string(file_size) + " bytes");
  return {};
}

/// Sends the rows to the sink; those of an interlaced image once its last pass completes them.
Expected<void> decodeRows(Decoder& decoder, int passes, const std::string& file, const RowSink& sink) {
  const png_structp png = decoder.png();
  const png_infop info = decoder.info();
  const ImageFormat format{png_get_image_width(png, info), png_get_image_height(png, info),
                           png_get_channels(png, info), png_get_bit_depth(png, info) == 16 ? 65535u : 255u};
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  if (passes > 1 && row_bytes * std::uint64_t{format.height} > kLargestInterlaced)
    return refuse(file, "is too large for an interlaced PNG; save it without interlacing");

  std::vector<png_byte> pixels(passes > 1 ? row_bytes * format.height : row_bytes);
  std::vector<std::uint16_t> samples(std::size_t{format.width} * format.channels);
  for (int pass = 1; pass <= passes; ++pass) {
    for (std::uint32_t y = 0; y < format.height; ++y) {
      png_byte* row = pixels.data() + (passes > 1 ? row_bytes * y : 0);
      if (!decoder.attempt([&] { png_read_row(png, row, nullptr); })) return refuseDamaged(file, decoder);
      if (pass < passes) continue;
      widen({row, row_bytes}, samples);
      sink(format, y, samples);
    }
  }
  return {};
}

}  // namespace

Expected<void> decodePng(std::string_view bytes, const std::string& file, const RowSink& sink) {
  Decoder decoder(bytes);
  if (!decoder.attempt([&] { decoder.start(); })) return refuseDamaged(file, decoder);
  if (const auto claims = checkClaims(decoder, bytes.size(), file); !claims) return claims;
  int passes = 1;
  if (!decoder.attempt([&] { passes = normalise(decoder.png(), decoder.info()); }))
    return refuseDamaged(file, decoder);
  if (const auto rows = decodeRows(decoder, passes, file, sink); !rows) return rows;
  if (!decoder.attempt([&] { png_read_end(decoder.png(), nullptr); })) return refuseDamaged(file, decoder);
  return {};
}

}  // namespace underway
