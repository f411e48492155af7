#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/convex.hpp"
#include "geometry/obstacles.hpp"
#include "geometry/rectangle.hpp"

namespace underway {

/// A convex piece of floor that an obstacle takes from a mode: a rectangle mostly.
struct Piece {
  Obstacles::Pointer obstacle;
  Rectangle around;            ///< the piece itself, or the smallest that holds the polygon
  std::vector<Point> polygon;  ///< counter-clockwise, map frame [m]; empty if the piece is a rectangle
  [[nodiscard]] bool isRectangle() const { return polygon.empty(); }
};
using PiecePointer = std::shared_ptr<const Piece>;

/// Calls `look(corners)` with a piece's corners, and returns what it does.
template <class Look>
auto withCorners(const Piece& piece, const Look& look) {
  if (!piece.isRectangle()) return look(ConvexView(piece.polygon));
  const auto corners = cornersOf(piece.around);
  return look(ConvexView(corners));
}

/// As many entries as a node of the tree has at most.
inline constexpr std::size_t kFan = 8;

/// How far areas are moved outwards, relative to their own coordinates: four half units in the last place of
/// single precision, for the four roundings at most that made the number they are compared with.
inline constexpr double kOutwards = 0x1.0p-22;

/// Axis-aligned areas of a node's entries, field by field for SIMD, moved outwards by kOutwards; relative to
/// the tree's origin, along the map's axes [m].
struct Areas {
  alignas(32) std::array<float, kFan> min_x, min_y, max_x, max_y;
};

/// Pieces lie in a tree of areas (an R-tree, Guttman 1984) whose nodes never change: a changed tree shares
/// all but the nodes on the way to the change. All leaves are equally deep.
struct Node {
  Areas areas;
  std::uint32_t used = 0;    ///< bit i: there is an entry i; those used are the first ones
  std::uint32_t height = 0;  ///< levels below it; 0: a Leaf, else a Branch
  [[nodiscard]] bool isLeaf() const { return height == 0; }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(std::popcount(used)); }
};
using NodePointer = std::shared_ptr<const Node>;

struct Branch : Node {
  std::array<NodePointer, kFan> below;
};

/// What a gap worked out in single precision may be off near contact, relative to the coordinates and sizes
/// that it is made of: at most nine roundings were seen there, and missed collisions begin when two are
/// allowed for. (Far from contact it may be off by more, which decides nothing.)
inline constexpr float kRoundings = 24.0F * 0x1.0p-24F;

/// Pieces, and their rectangles field by field for SIMD, relative to the tree's origin.
struct Leaf : Node {
  float error_m = 0.0F;          ///< what single precision may be off by, for the pieces' part
  std::uint32_t rectangles = 0;  ///< bit i: piece i is exactly its rectangle
  alignas(32) std::array<float, kFan> x, y, cos, sin, half_x, half_y;
  std::array<PiecePointer, kFan> pieces;
};

struct Tree {
  NodePointer root;         ///< null: no pieces
  Point origin;             ///< among the pieces it was made of, so that single precision does for those near
                            ///< it; map frame [m]
  std::size_t pieces = 0;   ///< it holds
  std::size_t changes = 0;  ///< since it was loaded; each leaves it a little worse to search
};

/// A balanced tree with full leaves (overlap-minimising top-down loading, Lee and Lee 2003), in n log n time.
[[nodiscard]] Tree treeOf(std::vector<Piece> pieces);
/// The same pieces, loaded anew.
[[nodiscard]] Tree renewed(const Tree& tree);
/// With one more.
[[nodiscard]] Tree with(const Tree& tree, PiecePointer piece);
/// Without the piece of an obstacle, found by what was flattened from it; the same tree if it is not there.
[[nodiscard]] Tree without(const Tree& tree, const Piece& piece);
/// How many levels a tree has at most: enough for 4^24 pieces.
inline constexpr std::size_t kMostLevels = 24;

}  // namespace underway
