#include "geometry/piece_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace underway {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// An axis-aligned area, rounded outwards.
struct Area {
  float min_x = kInfinite;
  float min_y = kInfinite;
  float max_x = -kInfinite;
  float max_y = -kInfinite;

  void include(const Area& other) {
    min_x = std::min(min_x, other.min_x);
    min_y = std::min(min_y, other.min_y);
    max_x = std::max(max_x, other.max_x);
    max_y = std::max(max_y, other.max_y);
  }
  [[nodiscard]] bool holds(const Area& other) const {
    return min_x <= other.min_x && min_y <= other.min_y && max_x >= other.max_x && max_y >= other.max_y;
  }
  /// Half the outline: unlike the area it also grows with what is flat.
  [[nodiscard]] float extent() const { return (max_x - min_x) + (max_y - min_y); }
  [[nodiscard]] float middleX() const { return 0.5F * (min_x + max_x); }
  [[nodiscard]] float middleY() const { return 0.5F * (min_y + max_y); }
};

/// Relative to an origin, and larger by what whoever compares with it in single precision may be off.
Area areaOf(const Piece& piece, Point origin) {
  const auto below = [](double value) { return static_cast<float>(value - kOutwards * std::abs(value)); };
  const auto above = [](double value) { return static_cast<float>(value + kOutwards * std::abs(value)); };
  Area area;
  withCorners(piece, [&](ConvexView corners) {
    for (const Point p : corners) {
      const double x = p.x - origin.x;
      const double y = p.y - origin.y;
      area.include({below(x), below(y), above(x), above(y)});
    }
  });
  return area;
}

Area areaOf(const Node& node, std::size_t i) {
  return {node.areas.min_x[i], node.areas.min_y[i], node.areas.max_x[i], node.areas.max_y[i]};
}

Area areaOf(const Node& node) {
  Area area;
  for (std::size_t i = 0; i < node.count(); ++i) area.include(areaOf(node, i));
  return area;
}

/// What a node holds, with its area: a piece in a leaf, a node in a branch.
template <class Held>
struct Entry {
  Area area;
  Held held;
};
using PieceEntry = Entry<PiecePointer>;
using NodeEntry = Entry<NodePointer>;

void setArea(Node& node, std::size_t i, const Area& area) {
  node.areas.min_x[i] = area.min_x;
  node.areas.min_y[i] = area.min_y;
  node.areas.max_x[i] = area.max_x;
  node.areas.max_y[i] = area.max_y;
}

/// Makes nodes, of pieces relative to an origin.
class Maker {
 public:
  explicit Maker(Point origin) : origin_(origin) {}

  [[nodiscard]] PieceEntry entryOf(PiecePointer piece) const {
    const Area area = areaOf(*piece, origin_);
    return {area, std::move(piece)};
  }

  [[nodiscard]] NodeEntry nodeOf(std::span<const PieceEntry> entries) const { return filled<Leaf>(entries); }
  [[nodiscard]] NodeEntry nodeOf(std::span<const NodeEntry> entries) const { return filled<Branch>(entries); }

  /// One node, or two when there is one entry too many.
  template <class Held>
  [[nodiscard]] std::vector<NodeEntry> nodesOf(std::vector<Entry<Held>> entries) const;

  /// Sets the i-th entry, which may be the first that is not used.
  void put(Leaf& leaf, std::size_t i, const PieceEntry& entry) const {
    const Rectangle& around = entry.held->around;
    setArea(leaf, i, entry.area);
    leaf.x[i] = static_cast<float>(around.center.x - origin_.x);
    leaf.y[i] = static_cast<float>(around.center.y - origin_.y);
    leaf.cos[i] = static_cast<float>(around.cos);
    leaf.sin[i] = static_cast<float>(around.sin);
    leaf.half_x[i] = static_cast<float>(around.half_x);
    leaf.half_y[i] = static_cast<float>(around.half_y);
    leaf.error_m = std::max(leaf.error_m, kRoundings * (std::abs(leaf.x[i]) + std::abs(leaf.y[i]) +
                                                        leaf.half_x[i] + leaf.half_y[i]));
    leaf.rectangles = (leaf.rectangles & ~(1U << i)) | (entry.held->isRectangle() ? 1U << i : 0U);
    leaf.used |= 1U << i;
    leaf.pieces[i] = entry.held;
  }

  void put(Branch& branch, std::size_t i, const NodeEntry& entry) const {
    setArea(branch, i, entry.area);
    branch.height = entry.held->height + 1;
    branch.used |= 1U << i;
    branch.below[i] = entry.held;
  }

  /// A copy with one entry set.
  template <class Kind, class Held>
  [[nodiscard]] NodeEntry withEntry(const Kind& node, std::size_t i, const Entry<Held>& entry) const {
    auto copy = std::make_shared<Kind>(node);
    put(*copy, i, entry);
    return {areaOf(*copy), copy};
  }

 private:
  template <class Kind, class Held>
  [[nodiscard]] NodeEntry filled(std::span<const Entry<Held>> entries) const {
    auto node = std::make_shared<Kind>();
    for (std::size_t i = 0; i < kFan; ++i) setArea(*node, i, {});
    for (std::size_t i = 0; i < entries.size(); ++i) put(*node, i, entries[i]);
    return {areaOf(*node), node};
  }

  Point origin_;
};

template <class Held>
Point middleOf(const Entry<Held>& entry) {
  return {static_cast<double>(entry.area.middleX()), static_cast<double>(entry.area.middleY())};
}

/// Orders things so that the middles of those before `cut` lie to one side of the rest, along the longer way.
template <class Things>
void part(Things things, std::size_t cut) {
  Point low = middleOf(things[0]);
  Point high = low;
  for (const auto& thing : things) {
    const Point at = middleOf(thing);
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  const auto order = [&](const auto& is_before) {
    std::nth_element(things.begin(), things.begin() + static_cast<std::ptrdiff_t>(cut), things.end(),
                     is_before);
  };
  if (high.x - low.x >= high.y - low.y)
    order([](const auto& a, const auto& b) { return middleOf(a).x < middleOf(b).x; });
  else
    order([](const auto& a, const auto& b) { return middleOf(a).y < middleOf(b).y; });
}

/// A piece by its middle and its place: small, so that many of them are moved about quickly.
struct Item {
  float x;
  float y;
  std::uint32_t piece;
};
Point middleOf(const Item& item) { return {static_cast<double>(item.x), static_cast<double>(item.y)}; }

/// Loads a tree top down from pieces that lie in one block.
class Loader {
 public:
  Loader(std::shared_ptr<const std::vector<Piece>> block, Point origin)
      : block_(std::move(block)), make_(origin), origin_(origin) {}

  [[nodiscard]] NodePointer load() const {
    std::vector<Item> items;
    items.reserve(block_->size());
    for (const Piece& piece : *block_)
      items.push_back({static_cast<float>(piece.around.center.x - origin_.x),
                       static_cast<float>(piece.around.center.y - origin_.y),
                       static_cast<std::uint32_t>(items.size())});
    std::size_t height = 0;
    for (std::size_t room = kFan; room < items.size(); room *= kFan) ++height;
    return nodeOf(items, height).held;
  }

 private:
  /// A node `height` levels above the leaves.
  [[nodiscard]] NodeEntry nodeOf(std::span<Item> items, std::size_t height) const {
    if (height == 0) return leafOf(items);
    std::size_t room = kFan;  // of one entry
    for (std::size_t level = 1; level < height; ++level) room *= kFan;
    std::vector<NodeEntry> entries;
    distribute(items, (items.size() + room - 1) / room, height - 1, entries);
    return make_.nodeOf(std::span<const NodeEntry>(entries));
  }

  [[nodiscard]] NodeEntry leafOf(std::span<const Item> items) const {
    std::vector<PieceEntry> entries;
    entries.reserve(items.size());
    for (const Item& item : items)
      entries.push_back(make_.entryOf(PiecePointer(block_, &(*block_)[item.piece])));
    return make_.nodeOf(std::span<const PieceEntry>(entries));
  }

  void distribute(std::span<Item> items, std::size_t parts, std::size_t height,
                  std::vector<NodeEntry>& entries) const {
    if (parts == 1) {
      entries.push_back(nodeOf(items, height));
      return;
    }
    const std::size_t before = parts / 2;
    const std::size_t cut = items.size() * before / parts;
    part(items, cut);
    distribute(items.first(cut), before, height, entries);
    distribute(items.subspan(cut), parts - before, height, entries);
  }

  std::shared_ptr<const std::vector<Piece>> block_;
  Maker make_;
  Point origin_;
};

template <class Held>
std::vector<NodeEntry> Maker::nodesOf(std::vector<Entry<Held>> entries) const {
  if (entries.size() <= kFan) return {nodeOf(std::span<const Entry<Held>>(entries))};
  const std::size_t half = entries.size() / 2;
  part(std::span<Entry<Held>>(entries), half);
  const std::span<const Entry<Held>> all(entries);
  return {nodeOf(all.first(half)), nodeOf(all.subspan(half))};
}

std::vector<PieceEntry> entriesOf(const Leaf& leaf) {
  std::vector<PieceEntry> entries;
  for (std::size_t i = 0; i < leaf.count(); ++i) entries.push_back({areaOf(leaf, i), leaf.pieces[i]});
  return entries;
}

std::vector<NodeEntry> entriesOf(const Branch& branch) {
  std::vector<NodeEntry> entries;
  for (std::size_t i = 0; i < branch.count(); ++i) entries.push_back({areaOf(branch, i), branch.below[i]});
  return entries;
}

/// The entry that grows least by taking an area in.
std::size_t bestFor(const Branch& branch, const Area& area) {
  std::size_t best = 0;
  std::pair<float, float> least{kInfinite, kInfinite};  // growth, then extent
  for (std::size_t i = 0; i < branch.count(); ++i) {
    Area grown = areaOf(branch, i);
    const float extent = grown.extent();
    grown.include(area);
    const std::pair<float, float> cost{grown.extent() - extent, extent};
    if (cost < least) least = cost, best = i;
  }
  return best;
}

std::vector<NodeEntry> inserted(const Maker& make, const Node& node, const PieceEntry& piece) {
  if (node.isLeaf()) {
    const auto& leaf = static_cast<const Leaf&>(node);
    if (leaf.count() < kFan) return {make.withEntry(leaf, leaf.count(), piece)};
    auto entries = entriesOf(leaf);
    entries.push_back(piece);
    return make.nodesOf(std::move(entries));
  }
  const auto& branch = static_cast<const Branch&>(node);
  const std::size_t best = bestFor(branch, piece.area);
  const auto changed = inserted(make, *branch.below[best], piece);
  if (changed.size() == 1) return {make.withEntry(branch, best, changed[0])};
  auto entries = entriesOf(branch);
  entries[best] = changed[0];
  entries.push_back(changed[1]);
  return make.nodesOf(std::move(entries));
}

/// The node without its i-th entry; empty (null) if nothing is left of it.
template <class Kind>
NodeEntry withoutEntry(const Maker& make, const Kind& node, std::size_t i) {
  auto entries = entriesOf(node);
  entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(i));
  return entries.empty() ? NodeEntry{} : make.nodeOf(std::span(std::as_const(entries)));
}

/// The node without the piece, empty (null) if nothing is left of it; none if the piece is not there.
std::optional<NodeEntry> removed(const Maker& make, const Node& node, const PieceEntry& piece) {
  if (node.isLeaf()) {
    const auto& leaf = static_cast<const Leaf&>(node);
    for (std::size_t i = 0; i < leaf.count(); ++i)
      if (leaf.pieces[i]->obstacle == piece.held->obstacle) return withoutEntry(make, leaf, i);
    return std::nullopt;
  }
  const auto& branch = static_cast<const Branch&>(node);
  for (std::size_t i = 0; i < branch.count(); ++i) {
    if (!areaOf(branch, i).holds(piece.area)) continue;
    const auto changed = removed(make, *branch.below[i], piece);
    if (!changed) continue;
    return changed->held ? make.withEntry(branch, i, *changed) : withoutEntry(make, branch, i);
  }
  return std::nullopt;
}

/// All pieces below a node.
void gather(const Node& node, std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < node.count(); ++i) {
    if (node.isLeaf())
      pieces.push_back(*static_cast<const Leaf&>(node).pieces[i]);
    else
      gather(*static_cast<const Branch&>(node).below[i], pieces);
  }
}

/// In the middle of pieces.
Point originOf(std::span<const Piece> pieces) {
  Range x{pieces[0].around.center.x, pieces[0].around.center.x};
  Range y{pieces[0].around.center.y, pieces[0].around.center.y};
  for (const Piece& piece : pieces) {
    const Point p = piece.around.center;
    x = hull(x, {p.x, p.x});
    y = hull(y, {p.y, p.y});
  }
  return {0.5 * (x.min + x.max), 0.5 * (y.min + y.max)};
}

}  // namespace

Tree treeOf(std::vector<Piece> pieces) {
  if (pieces.empty()) return {};
  const auto block = std::make_shared<const std::vector<Piece>>(std::move(pieces));
  const Point origin = originOf(*block);
  return {Loader(block, origin).load(), origin, block->size(), 0};
}

Tree renewed(const Tree& tree) {
  std::vector<Piece> pieces;
  pieces.reserve(tree.pieces);
  if (tree.root) gather(*tree.root, pieces);
  return treeOf(std::move(pieces));
}

Tree with(const Tree& tree, PiecePointer piece) {
  const Point origin = tree.root ? tree.origin : originOf(std::span(piece.get(), 1));
  const Maker make(origin);
  const PieceEntry entry = make.entryOf(std::move(piece));
  if (!tree.root) return {make.nodeOf(std::span(&entry, 1)).held, origin, 1, 0};
  const auto nodes = inserted(make, *tree.root, entry);
  return {nodes.size() == 1 ? nodes[0].held : make.nodeOf(std::span<const NodeEntry>(nodes)).held, origin,
          tree.pieces + 1, tree.changes + 1};
}

Tree without(const Tree& tree, const Piece& piece) {
  if (!tree.root) return tree;
  const Maker make(tree.origin);
  const auto left = removed(make, *tree.root, make.entryOf(PiecePointer(PiecePointer(), &piece)));
  if (!left) return tree;
  NodePointer root = left->held;
  // A root with a single branch below it is one level too many.
  while (root && !root->isLeaf() && root->count() == 1) root = static_cast<const Branch&>(*root).below[0];
  return {root, tree.origin, tree.pieces - 1, tree.changes + 1};
}

}  // namespace underway
