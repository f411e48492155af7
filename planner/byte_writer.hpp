#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace underway {

/// Writes numbers to bytes, little-endian on every machine; doubles bit for bit.
class ByteWriter {
 public:
  ByteWriter& u8(std::uint8_t value) { return number(value, 1); }
  ByteWriter& u32(std::uint32_t value) { return number(value, 4); }
  ByteWriter& u64(std::uint64_t value) { return number(value, 8); }
  ByteWriter& f64(double value) { return u64(std::bit_cast<std::uint64_t>(value)); }
  ByteWriter& text(std::string_view characters) { return bytes_.append(characters), *this; }

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  ByteWriter& number(std::uint64_t value, int size) {
    for (int byte = 0; byte < size; ++byte) bytes_.push_back(static_cast<char>(value >> (8 * byte) & 0xffU));
    return *this;
  }

  std::string bytes_;
};

}  // namespace underway
