#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/read/image.hpp"

namespace underway {

/// A binary PGM of one byte a pixel.
inline std::string pgmOf(std::uint32_t width, std::uint32_t height, const std::string& pixels) {
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + pixels;
}

/// Four bytes, the high one first.
inline std::string bigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

/// A chunk of a PNG, with its length and CRC.
inline std::string pngChunk(const std::string& type, const std::string& data) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : type + data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(~crc);
}

/// A zlib stream that holds the data as it is, in stored blocks.
inline std::string zlibStored(const std::string& data) {
  constexpr std::size_t kLargestBlock = 65535;
  std::string stream = "\x78\x01";
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  std::size_t at = 0;
  do {
    const std::string block = data.substr(at, kLargestBlock);
    at += block.size();
    const auto low = static_cast<char>(block.size() & 0xff);
    const auto high = static_cast<char>(block.size() >> 8);
    stream += static_cast<char>(at == data.size());
    stream += {low, high, static_cast<char>(~low), static_cast<char>(~high)};
    stream += block;
  } while (at < data.size());
  return stream + bigEndian(b << 16 | a);
}

/// What a PNG's header says. Colour types: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha.
struct PngHeader {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  int bit_depth = 8;
  int color_type = 0;
  bool is_interlaced = false;
};

inline std::string pngStart(const PngHeader& header) {
  std::string bytes = bigEndian(header.width) + bigEndian(header.height);
  for (const int byte : {header.bit_depth, header.color_type, 0, 0, header.is_interlaced ? 1 : 0})
    bytes += static_cast<char>(byte);
  return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", bytes);
}

/// A PNG of these packed scan lines, without their filter bytes. `chunks` go before the pixels: PLTE, tRNS.
inline std::string pngOf(const PngHeader& header, const std::vector<std::string>& lines,
                         const std::string& chunks = {}) {
  std::string raw;
  for (const std::string& line : lines) raw += '\0' + line;
  return pngStart(header) + chunks + pngChunk("IDAT", zlibStored(raw)) + pngChunk("IEND", "");
}

/// The scan lines of an 8 bit grey image in the order that an interlaced PNG (Adam7) keeps them.
inline std::vector<std::string> interlacedLines(std::uint32_t width, std::uint32_t height,
                                                const std::string& pixels) {
  struct Pass {
    std::uint32_t x, y, dx, dy;
  };
  constexpr std::array<Pass, 7> kPasses{
      {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
  std::vector<std::string> lines;
  for (const Pass& pass : kPasses) {
    for (std::uint32_t y = pass.y; y < height && pass.x < width; y += pass.dy) {
      lines.emplace_back();
      for (std::uint32_t x = pass.x; x < width; x += pass.dx) lines.back() += pixels[y * width + x];
    }
  }
  return lines;
}

/// A decoded image, held whole.
struct Picture {
  ImageFormat format;
  std::vector<std::uint16_t> samples;
};

inline Expected<Picture> decodeWhole(const std::string& bytes) {
  Picture picture;
  const auto keep = [&](const ImageFormat& format, std::uint32_t, std::span<const std::uint16_t> row) {
    picture.format = format;
    picture.samples.insert(picture.samples.end(), row.begin(), row.end());
  };
  if (const auto decoded = decodeImage(bytes, "sample", keep); !decoded)
    return tl::unexpected(decoded.error());
  return picture;
}

}  // namespace underway
