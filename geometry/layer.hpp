#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/convex.hpp"
#include "geometry/piece_tree.hpp"
#include "geometry/sweep.hpp"
#include "geometry/turning.hpp"
#include "geometry/world.hpp"

namespace underway {

/// Obstacles flattened for one question about the floor, in a tree: what a mode sees, or what hangs above it.
/// A value that does not change; a changed layer shares with it all that did not change.
///
/// Fast answers are given in single precision, eight pieces at a time; what is too near to contact for that
/// is decided by one routine in double precision (convex.hpp, turning.hpp), on every machine the same.
///
/// Thread safety: const members may be called from any number of threads.
class Layer {
 public:
  /// Each obstacle cut to a slab of heights and projected to the floor, exactly.
  [[nodiscard]] static Layer seenIn(Range slab, const Obstacles& obstacles);
  /// Whether every obstacle looks the same in two slabs: then one's layer does for the other, asked in it.
  [[nodiscard]] static bool looksAlike(Range a, Range b, const Obstacles& obstacles);
  [[nodiscard]] Layer askedIn(Range slab) const;
  /// What may hang above a height: all that reaches above it, but for upright boxes that also reach below it,
  /// which are seen already.
  [[nodiscard]] static Layer hangingAbove(double height_m, const Obstacles& obstacles);
  /// The layer that the same question makes of the obstacles after some changes; for few of many, else make
  /// it anew.
  [[nodiscard]] Layer changed(std::span<const Obstacles::Change> changes) const;

  /// Visited pieces come in no particular order. Return true to stop.
  using Visit = std::function<bool(const Piece&)>;
  [[nodiscard]] bool touches(const Prism& body) const;
  [[nodiscard]] bool touches(const Turning& turning) const;
  [[nodiscard]] bool touches(Point center, double radius_m) const;
  /// How far a body that touches no piece can turn before it does.
  [[nodiscard]] TurningRoom turningRoom(const Prism& body) const;
  void visitTouched(const Prism& body, const Visit& visit) const;
  void visitTouched(const Turning& turning, const Visit& visit) const;
  /// For many bodies: `touched[i]` becomes whether body i touches any piece.
  void touchEach(std::span<const Prism> bodies, std::span<char> touched) const;

  struct Neighbour {
    const Piece* piece;  ///< lives as long as the layer
    Gap gap;             ///< from the shape to the piece
  };
  /// The nearest piece that is nearer than a cap; of equally near ones that with the smallest id.
  [[nodiscard]] std::optional<Neighbour> nearest(const Prism& body, double cap_m) const;
  [[nodiscard]] std::optional<Neighbour> nearest(const Turning& turning, double cap_m) const;

  /// The tree itself, to look at.
  [[nodiscard]] const Tree& tree() const { return tree_; }

 private:
  enum class Question { kSeen, kHanging };
  Layer(Question question, Range slab, const Obstacles& obstacles);
  Layer(Question question, Range slab, Tree tree)
      : question_(question), slab_(slab), tree_(std::move(tree)) {}
  [[nodiscard]] std::optional<Piece> pieceFor(const Obstacles::Pointer& obstacle) const;

  Question question_;
  Range slab_;  // of heights that are flattened, a hair wider than asked
  Tree tree_;
};

}  // namespace underway
