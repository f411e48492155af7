#pragma once

#include <cstddef>
#include <span>

#include "geometry/piece_tree.hpp"
#include "geometry/sweep.hpp"

namespace underway {

/// What to do with the pieces that a fast look at the tree cannot tell to be apart from a shape.
class Sieve {
 public:
  virtual ~Sieve() = default;
  /// A piece that overlaps for certain, or (`is_certain` false) one that a closer look must tell. `shape` says
  /// which of the shapes it is, if there are many. Return true to stop.
  virtual bool keep(const Piece& piece, bool is_certain, std::size_t shape) = 0;
};

/// All that may lie between two circles about a point: what is certainly outside the outer one is apart, what
/// is certainly inside the inner one overlaps. [m], map frame.
struct Ring {
  Point center;
  double outer_m = 0.0;
  double inner_m = 0.0;
};

/// Sifts a tree's pieces in single precision, eight at a time: all pieces that are apart from the shape by
/// more than the error of single precision fall through, all others are kept. Returns whether the sieve
/// stopped it. Made for each instruction set that Highway knows of and chosen when the program runs; since
/// what is near contact is never decided here, all give the same answers.
///
/// Thread safety: may be called from any number of threads.
bool sift(const Tree& tree, const Prism& body, Sieve& sieve);
bool sift(const Tree& tree, const Ring& ring, Sieve& sieve);

/// For many bodies in one call; `stopped[i]` becomes whether the sieve stopped body i.
void siftEach(const Tree& tree, std::span<const Prism> bodies, Sieve& sieve, std::span<char> stopped);

}  // namespace underway
