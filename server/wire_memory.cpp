#include "server/wire_memory.hpp"

#include <algorithm>

namespace underway {

char* wireText(const std::string& text) {
  if (text.size() <= kLongestText) return dds_string_dup(text.c_str());
  std::size_t size = kLongestText;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size;
  return dds_string_dup(text.substr(0, size).c_str());
}

bool read(const char* wire, std::string& text) {
  if (wire == nullptr) return false;
  const std::size_t size = ::strnlen(wire, kLongestText + 1);
  text.assign(wire, std::min(size, kLongestText));
  return size <= kLongestText;
}

bool read(const bool& wire, bool& flag) {
  const auto byte = bitsOf<std::uint8_t>(wire);
  flag = byte == 1;
  return byte <= 1;
}

}  // namespace underway
