#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/piece_tree.hpp"
#include "geometry/sweep.hpp"

namespace underway {

/// All that may lie between two circles about a point: what is certainly outside the outer one is apart, what
/// is certainly inside the inner one overlaps. [m], map frame.
struct Ring {
  Point center;
  double outer_m = 0.0;
  double inner_m = 0.0;
};

/// Tells in double precision what single precision cannot.
class Closer {
 public:
  virtual ~Closer() = default;
  virtual bool touches(const Piece& piece) = 0;
};

/// The same for bodies: whether a piece touches a body's footprint.
[[nodiscard]] bool areTouching(const Prism& body, const Piece& piece);

/// Takes the pieces that a fast look at the tree cannot tell to be apart from a shape.
class Sieve {
 public:
  virtual ~Sieve() = default;
  /// A piece that overlaps for certain, or (`is_certain` false) one that a closer look must tell. Return true
  /// to stop.
  virtual bool keep(const Piece& piece, bool is_certain) = 0;
};

// These look at a tree's pieces in single precision, eight at a time. What is nearer to contact than single
// precision can tell is decided in double precision (areTouching, or the closer) or left to the
// sieve: so all instruction sets give the same answers. The code is made for each that Highway knows of, and
// chosen when the program runs.
//
// Thread safety: may be called from any number of threads.

/// Whether any piece touches the body's footprint.
[[nodiscard]] bool touches(const Tree& tree, const Prism& body);
/// For many bodies: `touched[i]` becomes whether any piece touches body i.
void touchEach(const Tree& tree, std::span<const Prism> bodies, std::span<char> touched);
/// Whether any piece touches the shape that the ring is about.
[[nodiscard]] bool touches(const Tree& tree, const Ring& ring, Closer& closer);
/// Gives the sieve all pieces that may touch, until it stops.
void sift(const Tree& tree, const Prism& body, Sieve& sieve);
void sift(const Tree& tree, const Ring& ring, Sieve& sieve);

/// The instruction sets that the code is made for and this machine has, the best one first: "AVX2", "SSE4".
[[nodiscard]] std::vector<std::string> instructionSets();
/// Uses one of them from now on, instead of the best one; for tests. Not while others call the functions
/// above.
void useInstructionSet(const std::string& name);

}  // namespace underway
