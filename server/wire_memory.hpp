#pragma once

#include <dds/dds.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "server/wire_limits.hpp"

namespace underway {

/// Texts and sequences of wire types, allocated so that dds_sample_free frees them.

/// A copy, cut at the longest text between two UTF-8 characters.
[[nodiscard]] char* wireText(const std::string& text);

/// Zeroed elements.
template <class Sequence>
auto allocate(Sequence& sequence, std::size_t count) {
  using Element = std::remove_pointer_t<decltype(sequence._buffer)>;
  if (count > 0) {
    sequence._buffer = static_cast<Element*>(dds_alloc(count * sizeof(Element)));
    std::memset(static_cast<void*>(sequence._buffer), 0, count * sizeof(Element));
  }
  sequence._length = sequence._maximum = static_cast<std::uint32_t>(count);
  sequence._release = true;
  return std::span(sequence._buffer, count);
}

/// A zeroed sample.
template <class Sample>
[[nodiscard]] Sample* allocate() {
  auto* sample = static_cast<Sample*>(dds_alloc(sizeof(Sample)));
  *sample = Sample{};
  return sample;
}

/// Whether a sequence that came holds no more than it may.
template <class Sequence>
[[nodiscard]] bool isCounted(const Sequence& sequence, std::size_t most) {
  return sequence._length <= most && (sequence._length == 0 || sequence._buffer != nullptr);
}

/// The text of a bounded string, or nothing if its end is missing.
template <std::size_t N>
[[nodiscard]] std::optional<std::string_view> textOf(const char (&field)[N]) {
  const void* end = std::memchr(field, '\0', N);
  if (end == nullptr) return std::nullopt;
  return std::string_view(field, static_cast<std::size_t>(static_cast<const char*>(end) - field));
}

/// Whether the text fits the field, end and all; a '\0' inside would shorten it on the wire.
template <std::size_t N>
[[nodiscard]] bool copyText(std::string_view text, char (&field)[N]) {
  if (text.size() >= N || text.find('\0') != std::string_view::npos) return false;
  std::copy(text.begin(), text.end(), field);
  return true;
}

/// Takes a text that came; false if it is missing or too long.
[[nodiscard]] bool read(const char* wire, std::string& text);
/// A flag that holds neither 0 nor 1 must not be used.
[[nodiscard]] bool read(const bool& wire, bool& flag);
/// Nor an enumerator beyond the last.
template <class Ours, class Wire>
[[nodiscard]] bool read(const Wire& wire, Ours last, Ours& value) {
  const auto number = bitsOf<std::uint32_t>(wire);
  value = static_cast<Ours>(number);
  return number <= static_cast<std::uint32_t>(last);
}

}  // namespace underway
