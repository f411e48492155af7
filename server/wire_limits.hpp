#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "planner/plan.hpp"
#include "server/served.hpp"

/// What idl/underway.idl allows, so that sender and receiver judge by the same rules.
namespace underway {

inline constexpr std::size_t kMostSegments = 4096;
inline constexpr std::size_t kMostBlocking = 64;
inline constexpr std::size_t kMostChanges = 1024;
inline constexpr std::size_t kMostModes = 16;
inline constexpr std::size_t kLongestText = 4096;    ///< [bytes]
inline constexpr std::size_t kLongestModeName = 64;  ///< [bytes]

template <class... Numbers>
[[nodiscard]] bool areFinite(Numbers... numbers) {
  return (std::isfinite(numbers) && ...);
}

/// A field's bits, without using it as what it claims to be: a bool that holds 2, or an enumerator that does
/// not exist, is undefined behaviour to look at. (std::bit_cast does look.)
template <class Bits, class Field>
[[nodiscard]] Bits bitsOf(const Field& field) {
  static_assert(sizeof(Bits) == sizeof(Field));
  Bits bits{};
  std::memcpy(&bits, &field, sizeof bits);
  return bits;
}

/// Whether the wire carries the text whole: not too long, and no '\0' inside.
[[nodiscard]] inline bool isCarried(std::string_view text, std::size_t longest = kLongestText) {
  return text.size() <= longest && text.find('\0') == std::string_view::npos;
}

/// What of a plan must be neither sent nor believed; empty when all is well.
[[nodiscard]] std::string faultOf(const Plan& plan, std::size_t mode_count);

/// What of it the wire cannot carry; empty when all is well.
[[nodiscard]] std::string faultOf(const Served& served);

}  // namespace underway
