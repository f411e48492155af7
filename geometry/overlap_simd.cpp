#include "geometry/overlap_simd.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

// This file is compiled once for each instruction set. It must not include Eigen, FCL or OMPL.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/overlap_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace underway {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kFan>;  // as many lanes as there are, up to a node's entries
using Vector = hn::Vec<Floats>;

// How many roundings in single precision, relative to the lengths that go in, a gap is at most made of; twice
// over.
constexpr float kRoundings = 16.0F * 0x1.0p-24F;
constexpr double kLeast_m = 2.0 * kContact_m;
constexpr std::size_t kMostBranches = kMostLevels * (kFan - 1) + 1;  // that wait at a time

struct Direction {
  double cos;
  double sin;
};

/// To 1e-8: enough beside single precision, and several times as fast as the library's. Taylor series within
/// an eighth of a turn, which are off by less than 2e-9 there; then quarter turns, without a branch that
/// nobody could predict.
HWY_INLINE Direction directionOf(double yaw) {
  if (!(std::abs(yaw) < 1e3)) return {std::cos(yaw), std::sin(yaw)};
  constexpr double kRoundsToInteger = 0x1.8p52;  // what is added to it loses its fraction
  const double shifted = yaw * (2.0 / std::numbers::pi) + kRoundsToInteger;
  const auto quarter = std::bit_cast<std::uint64_t>(shifted);  // its low bits
  const double r = yaw - (shifted - kRoundsToInteger) * (0.5 * std::numbers::pi);
  const double r2 = r * r;
  const double s = r * (1.0 + r2 * (-1.0 / 6 + r2 * (1.0 / 120 + r2 * (-1.0 / 5040 + r2 * (1.0 / 362880)))));
  const double c =
      1.0 + r2 * (-0.5 + r2 * (1.0 / 24 + r2 * (-1.0 / 720 + r2 * (1.0 / 40320 + r2 * (-1.0 / 3628800)))));
  const auto s_bits = std::bit_cast<std::uint64_t>(s);
  const auto c_bits = std::bit_cast<std::uint64_t>(c);
  const std::uint64_t swap = (s_bits ^ c_bits) & (0 - (quarter & 1U));
  return {std::bit_cast<double>(c_bits ^ swap ^ (((quarter + 1U) & 2U) << 62U)),
          std::bit_cast<double>(s_bits ^ swap ^ ((quarter & 2U) << 62U))};
}

struct Box {
  float min_x, min_y, max_x, max_y;
};

/// Rounded outwards by more than conversions are off, if the reach is so by itself.
constexpr double kOutwards = 0x1.0p-22;
HWY_INLINE Box boxAround(double x, double y, double reach_x, double reach_y) {
  reach_x += std::abs(x) * kOutwards;
  reach_y += std::abs(y) * kOutwards;
  return {static_cast<float>(x - reach_x), static_cast<float>(y - reach_y), static_cast<float>(x + reach_x),
          static_cast<float>(y + reach_y)};
}

HWY_INLINE std::uint32_t bitsOf(Floats d, hn::Mask<Floats> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] & ((1U << hn::Lanes(d)) - 1U);
}

/// Bit i: entry i of a node may meet a box. What is not finite meets everything.
HWY_INLINE std::uint32_t meeting(const Node& node, const Box& box) {
  const Floats d;
  const Areas& areas = node.areas;
  std::uint32_t apart = 0;
  for (std::size_t i = 0; i < kFan; i += hn::Lanes(d)) {
    const auto beyond_x = hn::Or(hn::Gt(hn::Load(d, areas.min_x.data() + i), hn::Set(d, box.max_x)),
                                 hn::Lt(hn::Load(d, areas.max_x.data() + i), hn::Set(d, box.min_x)));
    const auto beyond_y = hn::Or(hn::Gt(hn::Load(d, areas.min_y.data() + i), hn::Set(d, box.max_y)),
                                 hn::Lt(hn::Load(d, areas.max_y.data() + i), hn::Set(d, box.min_y)));
    apart |= bitsOf(d, hn::Or(beyond_x, beyond_y)) << i;
  }
  return ~apart & ((1U << node.count) - 1U);
}

/// Bits of a leaf's pieces: certainly apart, certainly overlapping; neither where rounding may decide.
struct Verdict {
  std::uint32_t apart = 0;
  std::uint32_t overlapping = 0;
};

constexpr double kMoreThanDiagonal = 0.415;  // sqrt(2) - 1, rounded up: hypot(a, b) <= a + that * b, if b <= a
constexpr double kCompact = 3.0;             // times the shorter half: size of a body that is as long as wide

/// A body's footprint, as a rectangle.
class RectangleTest {
 public:
  explicit HWY_INLINE RectangleTest(const Prism& body) {
    const Direction direction = directionOf(body.frame.yaw);
    const double mid_x = 0.5 * (body.x.min + body.x.max);
    const double mid_y = 0.5 * (body.y.min + body.y.max);
    const double half_x = 0.5 * (body.x.max - body.x.min);
    const double half_y = 0.5 * (body.y.max - body.y.min);
    x_ = body.frame.x + direction.cos * mid_x - direction.sin * mid_y;
    y_ = body.frame.y + direction.sin * mid_x + direction.cos * mid_y;
    const double size = std::abs(mid_x) + std::abs(mid_y) + half_x + half_y;
    const double slack = kLeast_m + kOutwards * size;
    const double reach_x = std::abs(direction.cos) * half_x + std::abs(direction.sin) * half_y + slack;
    const double reach_y = std::abs(direction.sin) * half_x + std::abs(direction.cos) * half_y + slack;
    // Of a compact body a box round its circle is nearly as small, and known before the direction is.
    const double longer = half_x > half_y ? half_x : half_y;
    const double shorter = half_x > half_y ? half_y : half_x;
    const double radius = std::abs(mid_x) + std::abs(mid_y) + longer + kMoreThanDiagonal * shorter + slack;
    box_ = size < kCompact * shorter ? boxAround(body.frame.x, body.frame.y, radius, radius)
                                     : boxAround(x_, y_, reach_x, reach_y);
    cos_ = static_cast<float>(direction.cos);
    sin_ = static_cast<float>(direction.sin);
    half_x_ = static_cast<float>(half_x);
    half_y_ = static_cast<float>(half_y);
    size_ = static_cast<float>(size);
  }

  [[nodiscard]] const Box& box() const { return box_; }

  /// Separating axes: the two of the body and the two of each piece.
  [[nodiscard]] HWY_INLINE Verdict operator()(const Leaf& leaf) const {
    const Floats d;
    const auto at_x = static_cast<float>(x_ - leaf.origin_x);
    const auto at_y = static_cast<float>(y_ - leaf.origin_y);
    const float error =
        kRoundings * (leaf.reach + std::abs(at_x) + std::abs(at_y) + size_) + static_cast<float>(kLeast_m);
    const Vector own_c = hn::Set(d, cos_), own_s = hn::Set(d, sin_);
    const Vector own_x = hn::Set(d, half_x_), own_y = hn::Set(d, half_y_);
    Verdict verdict;
    for (std::size_t i = 0; i < kFan; i += hn::Lanes(d)) {
      const Vector dx = hn::Sub(hn::Load(d, leaf.x.data() + i), hn::Set(d, at_x));
      const Vector dy = hn::Sub(hn::Load(d, leaf.y.data() + i), hn::Set(d, at_y));
      const Vector c = hn::Load(d, leaf.cos.data() + i), s = hn::Load(d, leaf.sin.data() + i);
      const Vector half_x = hn::Load(d, leaf.half_x.data() + i), half_y = hn::Load(d, leaf.half_y.data() + i);
      // The cosine and sine of the angle between the two.
      const Vector between_c = hn::Abs(hn::MulAdd(own_c, c, hn::Mul(own_s, s)));
      const Vector between_s = hn::Abs(hn::MulSub(own_c, s, hn::Mul(own_s, c)));
      const Vector own_ahead = hn::Abs(hn::MulAdd(own_c, dx, hn::Mul(own_s, dy)));
      const Vector own_aside = hn::Abs(hn::MulSub(own_c, dy, hn::Mul(own_s, dx)));
      const Vector ahead = hn::Abs(hn::MulAdd(c, dx, hn::Mul(s, dy)));
      const Vector aside = hn::Abs(hn::MulSub(c, dy, hn::Mul(s, dx)));
      const Vector gap_1 = hn::Sub(own_ahead, hn::MulAdd(half_y, between_s, hn::MulAdd(half_x, between_c, own_x)));
      const Vector gap_2 = hn::Sub(own_aside, hn::MulAdd(half_y, between_c, hn::MulAdd(half_x, between_s, own_y)));
      const Vector gap_3 = hn::Sub(ahead, hn::MulAdd(own_y, between_s, hn::MulAdd(own_x, between_c, half_x)));
      const Vector gap_4 = hn::Sub(aside, hn::MulAdd(own_y, between_c, hn::MulAdd(own_x, between_s, half_y)));
      const Vector gap = hn::Max(hn::Max(gap_1, gap_2), hn::Max(gap_3, gap_4));
      verdict.apart |= bitsOf(d, hn::Gt(gap, hn::Set(d, error))) << i;
      verdict.overlapping |= bitsOf(d, hn::Lt(gap, hn::Set(d, -error))) << i;
    }
    return verdict;
  }

 private:
  double x_, y_;  // the middle
  float cos_, sin_, half_x_, half_y_;
  float size_;  // of the numbers that go in
  Box box_;
};

/// What lies between two circles.
class RingTest {
 public:
  explicit RingTest(const Ring& ring)
      : x_(ring.center.x),
        y_(ring.center.y),
        outer_(static_cast<float>(ring.outer_m)),
        inner_(static_cast<float>(ring.inner_m)) {
    const double reach = ring.outer_m * (1.0 + kOutwards) + kLeast_m;
    box_ = boxAround(x_, y_, reach, reach);
  }

  [[nodiscard]] const Box& box() const { return box_; }

  /// By the distance of each piece's rectangle from the middle.
  [[nodiscard]] HWY_INLINE Verdict operator()(const Leaf& leaf) const {
    const Floats d;
    const auto at_x = static_cast<float>(x_ - leaf.origin_x);
    const auto at_y = static_cast<float>(y_ - leaf.origin_y);
    const float error =
        kRoundings * (leaf.reach + std::abs(at_x) + std::abs(at_y) + outer_) + static_cast<float>(kLeast_m);
    const Vector outside = hn::Set(d, (outer_ + error) * (outer_ + error));
    const float within = inner_ - error;
    const Vector inside = hn::Set(d, within > 0.0F ? within * within : 0.0F);
    Verdict verdict;
    for (std::size_t i = 0; i < kFan; i += hn::Lanes(d)) {
      const Vector dx = hn::Sub(hn::Load(d, leaf.x.data() + i), hn::Set(d, at_x));
      const Vector dy = hn::Sub(hn::Load(d, leaf.y.data() + i), hn::Set(d, at_y));
      const Vector c = hn::Load(d, leaf.cos.data() + i), s = hn::Load(d, leaf.sin.data() + i);
      const Vector ahead = hn::Sub(hn::Abs(hn::MulAdd(c, dx, hn::Mul(s, dy))), hn::Load(d, leaf.half_x.data() + i));
      const Vector aside = hn::Sub(hn::Abs(hn::MulSub(c, dy, hn::Mul(s, dx))), hn::Load(d, leaf.half_y.data() + i));
      const Vector x = hn::Max(ahead, hn::Zero(d));
      const Vector y = hn::Max(aside, hn::Zero(d));
      const Vector squared = hn::MulAdd(x, x, hn::Mul(y, y));
      verdict.apart |= bitsOf(d, hn::Gt(squared, outside)) << i;
      verdict.overlapping |= bitsOf(d, hn::Lt(squared, inside)) << i;
    }
    return verdict;
  }

 private:
  double x_, y_;
  float outer_, inner_;
  Box box_;
};

template <class Test>
bool siftNode(const Node& node, const Test& test, Sieve& sieve) {
  std::uint32_t left = meeting(node, test.box());
  std::uint32_t certain = 0;
  if (node.is_leaf && left != 0) {
    const auto& leaf = static_cast<const Leaf&>(node);
    const Verdict verdict = test(leaf);
    left &= ~verdict.apart;
    certain = verdict.overlapping & leaf.rectangles;
  }
  for (; left != 0; left &= left - 1U) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const bool stops = node.is_leaf
                           ? sieve.keep(*static_cast<const Leaf&>(node).pieces[i], (certain >> i & 1U) != 0)
                           : siftNode(*static_cast<const Branch&>(node).below[i], test, sieve);
    if (stops) return true;
  }
  return false;
}

/// Whether any of a leaf's pieces touches. Looks at all of them before it tells: whether the next one does is
/// a coin's toss, and a branch on it would cost more than the look.
template <class Test>
HWY_INLINE bool touchesLeaf(const Leaf& leaf, const Test& test, Closer& closer, std::size_t shape) {
  const Verdict verdict = test(leaf);
  const std::uint32_t left = ~verdict.apart & ((1U << leaf.count) - 1U);
  const std::uint32_t certain = left & verdict.overlapping & leaf.rectangles;
  if (HWY_UNLIKELY((left & ~certain) != 0) && certain == 0)
    for (std::uint32_t unsure = left; unsure != 0; unsure &= unsure - 1U)
      if (closer.touches(*leaf.pieces[static_cast<std::size_t>(std::countr_zero(unsure))], shape)) return true;
  return certain != 0;
}

template <class Test>
HWY_INLINE bool touchesTree(const Node& root, const Test& test, Closer& closer, std::size_t shape) {
  if (root.is_leaf) return touchesLeaf(static_cast<const Leaf&>(root), test, closer, shape);
  std::array<const Branch*, kMostBranches> waiting;
  std::size_t count = 0;
  waiting[count++] = static_cast<const Branch*>(&root);
  bool touches = false;
  while (count > 0 && !touches) {
    const Branch& branch = *waiting[--count];
    for (std::uint32_t left = meeting(branch, test.box()); left != 0; left &= left - 1U) {
      const Node& below = *branch.below[static_cast<std::size_t>(std::countr_zero(left))];
      if (below.is_leaf)
        touches |= touchesLeaf(static_cast<const Leaf&>(below), test, closer, shape);
      else
        waiting[count++] = static_cast<const Branch*>(&below);
    }
  }
  return touches;
}

void touchBodies(const Node& root, std::span<const Prism> bodies, Closer& closer, std::span<char> touched) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    touched[i] = touchesTree(root, RectangleTest(bodies[i]), closer, i) ? 1 : 0;
}

bool touchBody(const Node& root, const Prism& body, Closer& closer) {
  return touchesTree(root, RectangleTest(body), closer, 0);
}

bool touchRing(const Node& root, const Ring& ring, Closer& closer) {
  return touchesTree(root, RingTest(ring), closer, 0);
}

void siftBody(const Node& root, const Prism& body, Sieve& sieve) { siftNode(root, RectangleTest(body), sieve); }
void siftRing(const Node& root, const Ring& ring, Sieve& sieve) { siftNode(root, RingTest(ring), sieve); }

}  // namespace HWY_NAMESPACE
}  // namespace underway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace underway {

HWY_EXPORT(touchBodies);
HWY_EXPORT(touchBody);
HWY_EXPORT(touchRing);
HWY_EXPORT(siftBody);
HWY_EXPORT(siftRing);

void touchEach(const Tree& tree, std::span<const Prism> bodies, Closer& closer, std::span<char> touched) {
  if (tree)
    HWY_DYNAMIC_DISPATCH(touchBodies)(*tree, bodies, closer, touched);
  else
    std::fill(touched.begin(), touched.end(), 0);
}

bool touches(const Tree& tree, const Prism& body, Closer& closer) {
  return tree && HWY_DYNAMIC_DISPATCH(touchBody)(*tree, body, closer);
}

bool touches(const Tree& tree, const Ring& ring, Closer& closer) {
  return tree && HWY_DYNAMIC_DISPATCH(touchRing)(*tree, ring, closer);
}

void sift(const Tree& tree, const Prism& body, Sieve& sieve) {
  if (tree) HWY_DYNAMIC_DISPATCH(siftBody)(*tree, body, sieve);
}

void sift(const Tree& tree, const Ring& ring, Sieve& sieve) {
  if (tree) HWY_DYNAMIC_DISPATCH(siftRing)(*tree, ring, sieve);
}

}  // namespace underway
#endif
