#include "tests/judge/image.hpp"

#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <fstream>
#include <istream>
#include <limits>
#include <memory>
#include <string>

namespace judge {
namespace {

constexpr std::size_t kMostPixels = 100'000'000;
constexpr png_uint_32 kWidestPng = 10'000;

/// A number of a PGM header or of P2 data, after white space and '#' comments.
std::size_t nextNumber(std::istream& in, const std::filesystem::path& file) {
  while (in >> std::ws && in.peek() == '#') in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  std::size_t number = 0;
  if (!(in >> number))
    throw InputError(file.string() + ": the PGM ends early or holds something that is no number");
  return number;
}

std::size_t nextBytes(std::istream& in, bool two, const std::filesystem::path& file) {
  const auto byte = [&] {
    const int value = in.get();
    if (value < 0) throw InputError(file.string() + ": the PGM holds fewer pixels than its header says");
    return static_cast<std::size_t>(value);
  };
  const std::size_t first = byte();
  return two ? 256 * first + byte() : first;
}

Image readPgm(std::istream& in, bool binary, const std::filesystem::path& file) {
  Image image;
  image.width = nextNumber(in, file);
  image.height = nextNumber(in, file);
  const std::size_t white = nextNumber(in, file);
  if (white == 0 || white > 65535)
    throw InputError(file.string() + ": a PGM's largest value lies in 1..65535");
  image.white = static_cast<double>(white);
  in.get();  // exactly one white space ends the header
  if (image.width == 0 || image.height == 0 || image.width > kMostPixels / image.height)
    throw InputError(file.string() + ": no image of " + std::to_string(image.width) + " x " +
                     std::to_string(image.height) + " pixels can be read");
  const std::size_t pixels = image.width * image.height;
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::size_t value = binary ? nextBytes(in, white > 255, file) : nextNumber(in, file);
    image.shade.push_back(static_cast<double>(value));
  }
  return image;
}

/// libpng jumps here when a file is broken, so no C++ object may live in this frame.
bool decode(png_structp reader, png_infop info, std::FILE* in) {
  if (setjmp(png_jmpbuf(reader)) != 0) return false;
  png_set_user_limits(reader, kWidestPng, kWidestPng);
  png_init_io(reader, in);
  png_read_png(reader, info, PNG_TRANSFORM_EXPAND | PNG_TRANSFORM_GRAY_TO_RGB, nullptr);
  return true;
}

double shadeOf(png_const_bytep row, std::size_t column, std::size_t channels, bool wide) {
  double sum = 0.0;
  for (std::size_t i = column * channels; i < (column + 1) * channels; ++i)
    sum += wide ? 256 * row[2 * i] + row[2 * i + 1] : row[i];
  return sum;
}

Image readPng(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"), &std::fclose);
  const auto silent = [](png_structp, png_const_charp) {};
  const auto give_up = [](png_structp png, png_const_charp) { png_longjmp(png, 1); };
  png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, give_up, silent);
  png_infop info = png_create_info_struct(reader);
  const auto close = [&](png_struct*) { png_destroy_read_struct(&reader, &info, nullptr); };
  const std::unique_ptr<png_struct, decltype(close)> closer(reader, close);
  if (!decode(reader, info, in.get())) throw InputError(file.string() + ": neither a sound PNG nor a PGM");

  const std::size_t channels = png_get_channels(reader, info);
  const bool wide = png_get_bit_depth(reader, info) == 16;
  Image image{png_get_image_width(reader, info), png_get_image_height(reader, info), 0.0, {}};
  image.white = (wide ? 65535.0 : 255.0) * static_cast<double>(channels);
  png_bytepp rows = png_get_rows(reader, info);
  for (std::size_t row = 0; row < image.height; ++row)
    for (std::size_t column = 0; column < image.width; ++column)
      image.shade.push_back(shadeOf(rows[row], column, channels, wide));
  return image;
}

}  // namespace

Image readImage(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": cannot be opened");
  std::string magic(2, '\0');
  in.read(magic.data(), 2);
  if (magic == "P5" || magic == "P2") return readPgm(in, magic == "P5", file);
  return readPng(file);
}

}  // namespace judge
