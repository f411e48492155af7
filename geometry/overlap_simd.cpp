#include "geometry/overlap_simd.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

// This file is compiled once for each instruction set. It must not include Eigen, FCL or OMPL.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/overlap_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef UNDERWAY_KERNELS
#define UNDERWAY_KERNELS
namespace underway {

/// What is made for each instruction set. Trees have a root here.
struct Kernels {
  bool (*touch_body)(const Tree&, const Prism&);
  void (*touch_bodies)(const Tree&, std::span<const Prism>, std::span<char>);
  bool (*touch_ring)(const Tree&, const Ring&, Closer&);
  void (*sift_body)(const Tree&, const Prism&, Sieve&);
  void (*sift_ring)(const Tree&, const Ring&, Sieve&);
};

}  // namespace underway
#endif

HWY_BEFORE_NAMESPACE();
namespace underway {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kFan>;  // as many lanes as there are, up to a node's entries
using Vector = hn::Vec<Floats>;

constexpr float kLeast_m = 2e-9F;                                    // twice a contact
constexpr std::size_t kMostBranches = kMostLevels * (kFan - 1) + 1;  // that wait at a time

struct Direction {
  float cos;
  float sin;
};

/// Far from 0, where one seldom is. Out of line: the library's results go through memory.
HWY_NOINLINE Direction farDirectionOf(double yaw) {
  return {static_cast<float>(std::cos(yaw)), static_cast<float>(std::sin(yaw))};
}

/// To single precision, and several times as fast as the library's: polynomials for half the angle, within
/// half a turn (interpolated at Chebyshev nodes; off by less than 5e-8), and the formulas for the double
/// angle. No branch that nobody could predict.
HWY_INLINE Direction directionOf(double yaw) {
  if (HWY_UNLIKELY(!(std::abs(yaw) < 1e3))) return farDirectionOf(yaw);
  constexpr double kRoundsToInteger = 0x1.8p52;  // what is added to it loses its fraction
  const double turns = (yaw * (0.5 / std::numbers::pi) + kRoundsToInteger) - kRoundsToInteger;
  const auto half = static_cast<float>(0.5 * yaw - turns * std::numbers::pi);
  const float z = half * half;
  const float s =
      half * (0.9999999957F +
              z * (-0.1666665795F + z * (0.008333050171F + z * (-1.980901741e-4F + z * 2.605107635e-6F))));
  const float c = 0.999999953F +
                  z * (-0.4999990478F + z * (0.04166357316F + z * (-1.385362954e-3F + z * 2.315241666e-5F)));
  return {1.0F - 2.0F * s * s, 2.0F * s * c};
}

/// Axis-aligned, relative to a tree's origin.
struct Box {
  float min_x, min_y, max_x, max_y;
};

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
  return ~apart & node.used;
}

/// Bits of a leaf's pieces: certainly apart, certainly overlapping; neither where rounding may decide.
struct Verdict {
  std::uint32_t apart = 0;
  std::uint32_t overlapping = 0;
};

constexpr float kMoreThanDiagonal =
    0.415F;  // sqrt(2) - 1, rounded up: hypot(a, b) <= a + that * b, if b <= a
constexpr float kSlack = 8.0F * static_cast<float>(kOutwards);  // of a box, relative to the body
constexpr float kCompact = 3.0F;  // times the shorter half: size of a body that is as long as wide

/// A body's footprint, as a rectangle.
class RectangleTest {
 public:
  HWY_INLINE RectangleTest(const Prism& body, Point origin) {
    const auto at_x = static_cast<float>(body.frame.x - origin.x);
    const auto at_y = static_cast<float>(body.frame.y - origin.y);
    const auto mid_x = static_cast<float>(0.5 * (body.x.min + body.x.max));
    const auto mid_y = static_cast<float>(0.5 * (body.y.min + body.y.max));
    half_x_ = static_cast<float>(0.5 * (body.x.max - body.x.min));
    half_y_ = static_cast<float>(0.5 * (body.y.max - body.y.min));
    const Direction direction = directionOf(body.frame.yaw);
    cos_ = direction.cos;
    sin_ = direction.sin;
    x_ = at_x + cos_ * mid_x - sin_ * mid_y;
    y_ = at_y + sin_ * mid_x + cos_ * mid_y;
    const float offset = std::abs(mid_x) + std::abs(mid_y);
    const float size = offset + half_x_ + half_y_;
    error_ = kRoundings * (std::abs(at_x) + std::abs(at_y) + size) + kLeast_m;
    // Of a compact body a box round its circle is nearly as small, and known before the direction is.
    const float shorter = half_x_ < half_y_ ? half_x_ : half_y_;
    const float longer = half_x_ < half_y_ ? half_y_ : half_x_;
    const float slack = kSlack * size + kLeast_m;
    if (size < kCompact * shorter) {
      const float reach = offset + longer + kMoreThanDiagonal * shorter + slack;
      box_ = {at_x - reach, at_y - reach, at_x + reach, at_y + reach};
    } else {
      const float reach_x = std::abs(cos_) * half_x_ + std::abs(sin_) * half_y_ + slack;
      const float reach_y = std::abs(sin_) * half_x_ + std::abs(cos_) * half_y_ + slack;
      box_ = {x_ - reach_x, y_ - reach_y, x_ + reach_x, y_ + reach_y};
    }
  }

  [[nodiscard]] const Box& box() const { return box_; }

  /// Separating axes: the two of the body and the two of each piece.
  [[nodiscard]] HWY_INLINE Verdict operator()(const Leaf& leaf) const {
    const Floats d;
    const Vector at_x = hn::Set(d, x_), at_y = hn::Set(d, y_);
    const Vector error = hn::Set(d, leaf.error_m + error_);
    const Vector own_c = hn::Set(d, cos_), own_s = hn::Set(d, sin_);
    const Vector own_x = hn::Set(d, half_x_), own_y = hn::Set(d, half_y_);
    Verdict verdict;
    for (std::size_t i = 0; i < kFan; i += hn::Lanes(d)) {
      const Vector dx = hn::Sub(hn::Load(d, leaf.x.data() + i), at_x);
      const Vector dy = hn::Sub(hn::Load(d, leaf.y.data() + i), at_y);
      const Vector c = hn::Load(d, leaf.cos.data() + i), s = hn::Load(d, leaf.sin.data() + i);
      const Vector half_x = hn::Load(d, leaf.half_x.data() + i), half_y = hn::Load(d, leaf.half_y.data() + i);
      // The cosine and sine of the angle between the two.
      const Vector between_c = hn::Abs(hn::MulAdd(own_c, c, hn::Mul(own_s, s)));
      const Vector between_s = hn::Abs(hn::MulSub(own_c, s, hn::Mul(own_s, c)));
      const Vector own_ahead = hn::Abs(hn::MulAdd(own_c, dx, hn::Mul(own_s, dy)));
      const Vector own_aside = hn::Abs(hn::MulSub(own_c, dy, hn::Mul(own_s, dx)));
      const Vector ahead = hn::Abs(hn::MulAdd(c, dx, hn::Mul(s, dy)));
      const Vector aside = hn::Abs(hn::MulSub(c, dy, hn::Mul(s, dx)));
      const Vector gap_1 =
          hn::Sub(own_ahead, hn::MulAdd(half_y, between_s, hn::MulAdd(half_x, between_c, own_x)));
      const Vector gap_2 =
          hn::Sub(own_aside, hn::MulAdd(half_y, between_c, hn::MulAdd(half_x, between_s, own_y)));
      const Vector gap_3 = hn::Sub(ahead, hn::MulAdd(own_y, between_s, hn::MulAdd(own_x, between_c, half_x)));
      const Vector gap_4 = hn::Sub(aside, hn::MulAdd(own_y, between_c, hn::MulAdd(own_x, between_s, half_y)));
      const Vector gap = hn::Max(hn::Max(gap_1, gap_2), hn::Max(gap_3, gap_4));
      verdict.apart |= bitsOf(d, hn::Gt(gap, error)) << i;
      verdict.overlapping |= bitsOf(d, hn::Gt(hn::Neg(error), gap)) << i;
    }
    return verdict;
  }

 private:
  float x_, y_;  // the middle, from the tree's origin
  float cos_, sin_, half_x_, half_y_;
  float error_;  // the body's part of what a gap may be off
  Box box_;
};

/// What lies between two circles.
class RingTest {
 public:
  RingTest(const Ring& ring, Point origin)
      : x_(static_cast<float>(ring.center.x - origin.x)),
        y_(static_cast<float>(ring.center.y - origin.y)),
        outer_(static_cast<float>(ring.outer_m)),
        inner_(static_cast<float>(ring.inner_m)),
        error_(kRoundings * (std::abs(x_) + std::abs(y_) + outer_) + kLeast_m) {
    const float reach = outer_ + kSlack * outer_ + kLeast_m;
    box_ = {x_ - reach, y_ - reach, x_ + reach, y_ + reach};
  }

  [[nodiscard]] const Box& box() const { return box_; }

  /// By the distance of each piece's rectangle from the middle.
  [[nodiscard]] HWY_INLINE Verdict operator()(const Leaf& leaf) const {
    const Floats d;
    const Vector at_x = hn::Set(d, x_), at_y = hn::Set(d, y_);
    const float error = leaf.error_m + error_;
    const Vector outside = hn::Set(d, (outer_ + error) * (outer_ + error));
    const float within = inner_ - error;
    const Vector inside = hn::Set(d, within > 0.0F ? within * within : 0.0F);
    Verdict verdict;
    for (std::size_t i = 0; i < kFan; i += hn::Lanes(d)) {
      const Vector dx = hn::Sub(hn::Load(d, leaf.x.data() + i), at_x);
      const Vector dy = hn::Sub(hn::Load(d, leaf.y.data() + i), at_y);
      const Vector c = hn::Load(d, leaf.cos.data() + i), s = hn::Load(d, leaf.sin.data() + i);
      const Vector ahead =
          hn::Sub(hn::Abs(hn::MulAdd(c, dx, hn::Mul(s, dy))), hn::Load(d, leaf.half_x.data() + i));
      const Vector aside =
          hn::Sub(hn::Abs(hn::MulSub(c, dy, hn::Mul(s, dx))), hn::Load(d, leaf.half_y.data() + i));
      const Vector x = hn::Max(ahead, hn::Zero(d));
      const Vector y = hn::Max(aside, hn::Zero(d));
      const Vector squared = hn::MulAdd(x, x, hn::Mul(y, y));
      verdict.apart |= bitsOf(d, hn::Gt(squared, outside)) << i;
      verdict.overlapping |= bitsOf(d, hn::Lt(squared, inside)) << i;
    }
    return verdict;
  }

 private:
  float x_, y_;  // the middle, from the tree's origin
  float outer_, inner_;
  float error_;  // the ring's part of what a gap may be off
  Box box_;
};

template <class Test>
bool siftNode(const Node& node, const Test& test, Sieve& sieve) {
  std::uint32_t left = meeting(node, test.box());
  std::uint32_t certain = 0;
  if (node.isLeaf() && left != 0) {
    const auto& leaf = static_cast<const Leaf&>(node);
    const Verdict verdict = test(leaf);
    left &= ~verdict.apart;
    certain = verdict.overlapping & leaf.rectangles;
  }
  for (; left != 0; left &= left - 1U) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const bool stops = node.isLeaf()
                           ? sieve.keep(*static_cast<const Leaf&>(node).pieces[i], (certain >> i & 1U) != 0)
                           : siftNode(*static_cast<const Branch&>(node).below[i], test, sieve);
    if (stops) return true;
  }
  return false;
}

/// In double precision, by the same code for all instruction sets, for the pieces that single precision
/// leaves open.
struct ExactBody {
  const Prism& body;
  bool touches(const Piece& piece) const { return areTouching(body, piece); }
};

struct ExactShape {
  Closer& closer;
  bool touches(const Piece& piece) const { return closer.touches(piece); }
};

/// Whether any of a leaf's pieces touches. Looks at all of them before it tells: whether the next one does is
/// a coin's toss, and a branch on it would cost more than the look.
template <class Test, class Exact>
HWY_INLINE bool touchesLeaf(const Leaf& leaf, const Test& test, const Exact& exact) {
  const Verdict verdict = test(leaf);
  const std::uint32_t left = ~verdict.apart & leaf.used;
  const std::uint32_t certain = left & verdict.overlapping & leaf.rectangles;
  if (HWY_UNLIKELY((left & ~certain) != 0) && certain == 0)
    for (std::uint32_t unsure = left; unsure != 0; unsure &= unsure - 1U)
      if (exact.touches(*leaf.pieces[static_cast<std::size_t>(std::countr_zero(unsure))])) return true;
  return certain != 0;
}

/// Of a branch right above the leaves.
template <class Test, class Exact>
HWY_INLINE bool touchesLeaves(const Branch& branch, const Test& test, const Exact& exact) {
  bool touches = false;
  for (std::uint32_t left = meeting(branch, test.box()); left != 0; left &= left - 1U) {
    const Node& below = *branch.below[static_cast<std::size_t>(std::countr_zero(left))];
    touches |= touchesLeaf(static_cast<const Leaf&>(below), test, exact);
  }
  return touches;
}

template <class Test, class Exact>
HWY_INLINE bool touchesDeep(const Branch& root, const Test& test, const Exact& exact) {
  std::array<const Branch*, kMostBranches> waiting;
  std::size_t count = 0;
  waiting[count++] = &root;
  bool touches = false;
  while (count > 0 && !touches) {
    const Branch& branch = *waiting[--count];
    if (branch.height == 1) {
      touches = touchesLeaves(branch, test, exact);
      continue;
    }
    for (std::uint32_t left = meeting(branch, test.box()); left != 0; left &= left - 1U) {
      const Node& below = *branch.below[static_cast<std::size_t>(std::countr_zero(left))];
      waiting[count++] = static_cast<const Branch*>(&below);
    }
  }
  return touches;
}

template <class Test, class Exact>
HWY_INLINE bool touchesTree(const Node& root, const Test& test, const Exact& exact) {
  if (root.isLeaf()) return touchesLeaf(static_cast<const Leaf&>(root), test, exact);
  const auto& branch = static_cast<const Branch&>(root);
  return branch.height == 1 ? touchesLeaves(branch, test, exact) : touchesDeep(branch, test, exact);
}

bool touchBody(const Tree& tree, const Prism& body) {
  return touchesTree(*tree.root, RectangleTest(body, tree.origin), ExactBody{body});
}

void touchBodies(const Tree& tree, std::span<const Prism> bodies, std::span<char> touched) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    touched[i] = touchesTree(*tree.root, RectangleTest(bodies[i], tree.origin), ExactBody{bodies[i]}) ? 1 : 0;
}

bool touchRing(const Tree& tree, const Ring& ring, Closer& closer) {
  return touchesTree(*tree.root, RingTest(ring, tree.origin), ExactShape{closer});
}

void siftBody(const Tree& tree, const Prism& body, Sieve& sieve) {
  siftNode(*tree.root, RectangleTest(body, tree.origin), sieve);
}

void siftRing(const Tree& tree, const Ring& ring, Sieve& sieve) {
  siftNode(*tree.root, RingTest(ring, tree.origin), sieve);
}

Kernels kernels() { return {touchBody, touchBodies, touchRing, siftBody, siftRing}; }

}  // namespace HWY_NAMESPACE
}  // namespace underway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace underway {

HWY_EXPORT(kernels);

namespace {

/// The best that this machine has, looked up when the program starts.
Kernels chosen = HWY_DYNAMIC_DISPATCH(kernels)();

}  // namespace

bool areTouching(const Prism& body, const Piece& piece) {
  return withCorners(piece, [&](ConvexView corners) { return areTouching(body.footprint(), corners); });
}

std::vector<std::string> instructionSets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    names.emplace_back(hwy::TargetName(target));
  return names;
}

void useInstructionSet(const std::string& name) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (name != hwy::TargetName(target)) continue;
    hwy::GetChosenTarget().Update(target);
    chosen = HWY_DYNAMIC_DISPATCH(kernels)();
    return;
  }
  throw std::invalid_argument("this machine has no instruction set " + name);
}

bool touches(const Tree& tree, const Prism& body) { return tree.root && chosen.touch_body(tree, body); }

bool touches(const Tree& tree, const Ring& ring, Closer& closer) {
  return tree.root && chosen.touch_ring(tree, ring, closer);
}

void touchEach(const Tree& tree, std::span<const Prism> bodies, std::span<char> touched) {
  if (tree.root)
    chosen.touch_bodies(tree, bodies, touched);
  else
    std::fill(touched.begin(), touched.end(), 0);
}

void sift(const Tree& tree, const Prism& body, Sieve& sieve) {
  if (tree.root) chosen.sift_body(tree, body, sieve);
}

void sift(const Tree& tree, const Ring& ring, Sieve& sieve) {
  if (tree.root) chosen.sift_ring(tree, ring, sieve);
}

}  // namespace underway
#endif
