#pragma once

#include <cstdint>

#include "geometry/robot.hpp"
#include "planner/plan.hpp"

namespace underway {

/// What a policy compares: for kPriority the millimetres moved in the last mode, ..., in the second mode,
/// then the time; for the others the time alone. All in one integer, the most important field highest, so
/// that adding and comparing costs what it does for a number: four fields of 22 bits [mm], one of 40 bits
/// [us].
class Cost {
 public:
  constexpr Cost() = default;
  static constexpr Cost time(std::uint64_t us) { return Cost(us); }
  /// Of moving in a mode, by Robot's order; the first mode's distance does not count.
  static constexpr Cost distance(ModeId mode, std::uint32_t mm) {
    return mode == 0 ? Cost() : Cost(Bits{mm} << (40 + 22 * (mode - 1)));
  }

  /// More than any route costs.
  static constexpr Cost most() { return Cost(~Bits{0}); }

  /// Never more than `most`.
  constexpr Cost operator+(Cost other) const {
    Bits sum = 0;
    return Cost(__builtin_add_overflow(bits_, other.bits_, &sum) ? ~Bits{0} : sum);
  }
  /// Of a larger one.
  constexpr Cost operator-(Cost other) const { return Cost(bits_ - other.bits_); }
  constexpr auto operator<=>(const Cost&) const = default;
  [[nodiscard]] constexpr std::uint64_t us() const {
    return static_cast<std::uint64_t>(bits_) & ((1ULL << 40) - 1);
  }

 private:
  __extension__ using Bits = unsigned __int128;
  constexpr explicit Cost(Bits bits) : bits_(bits) {}
  Bits bits_ = 0;
};
static_assert(kMaxModes == 5, "Cost has fields for the four modes after the first");

/// What one motion costs under a policy. Times are rounded up, so that straight-line heuristics stay
/// consistent, and every motion costs 1 us more than it takes: of two equal routes the one with fewer motions
/// wins.
[[nodiscard]] Cost costOf(const Robot& robot, Policy policy, const Motion& motion);

}  // namespace underway
