#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace underway {

/// Reads what ByteWriter wrote. Beyond the end everything is zero, and hasFailed() tells so: whoever reads
/// checks once, after all of it. Before making room for a count that was read, ask whether `holds` it.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t u64() { return number(8); }
  double f64() { return std::bit_cast<double>(u64()); }
  std::string_view text(std::size_t size) {
    if (!holds(1, size)) return fail(), std::string_view{};
    const std::string_view read = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return read;
  }

  /// Whether as many things, of at least so many bytes each (>= 1), may still come.
  [[nodiscard]] bool holds(std::uint64_t count, std::size_t bytes_each) const {
    return count <= bytes_.size() / bytes_each;
  }
  [[nodiscard]] std::string_view rest() const { return bytes_; }
  [[nodiscard]] bool hasFailed() const { return has_failed_; }
  [[nodiscard]] bool isAtEnd() const { return bytes_.empty() && !has_failed_; }

 private:
  void fail() {
    has_failed_ = true;
    bytes_ = {};
  }
  std::uint64_t number(std::size_t size) {
    if (bytes_.size() < size) return fail(), 0;
    std::uint64_t value = 0;
    for (std::size_t byte = 0; byte < size; ++byte)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[byte])) << (8 * byte);
    bytes_.remove_prefix(size);
    return value;
  }

  std::string_view bytes_;
  bool has_failed_ = false;
};

}  // namespace underway
