#include "planner/proof/cell_tree.hpp"

#include <algorithm>

namespace underway::proof {
namespace {

constexpr std::size_t kDeepest = 3 * 24 + 2;  // an axis of 2^24 units is halved no more often than that

/// Whether two ranges touch or overlap.
bool meet(UnitRange a, UnitRange b) { return a.low <= b.high && b.low <= a.high; }

}  // namespace

Contact contactOf(const CellBox& from, const CellBox& to) {
  Contact contact;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const UnitRange a = from[axis];
    const UnitRange b = to[axis];
    if (std::min(a.high, b.high) > std::max(a.low, b.low)) continue;
    const bool is_upwards = a.high == b.low || (axis == kYaw && a.high == kWholeAxis && b.low == 0);
    const bool is_downwards = b.high == a.low || (axis == kYaw && b.high == kWholeAxis && a.low == 0);
    if (contact.is_face || (!is_upwards && !is_downwards)) return {};
    contact = {true, axis, is_upwards};
  }
  return contact;
}

CellTree::CellTree(bool joins_headings) : joins_headings_(joins_headings), boxes_(1), rows_(1) {
  branches_.push_back({kX, 0, kLeaf, kLeaf});  // above it is everything
  sites_.push_back({0, true});
  for (int round = 0; round < 3; ++round)
    for (CellId cell = 0, count = static_cast<CellId>(size()); cell < count; ++cell) halve(cell, kYaw);
  for (CellId a = 0; a < size(); ++a)
    for (CellId b = 0; b < size(); ++b)
      if (a != b && areNeighbours(a, b)) addNeighbour(a, b);
}

bool CellTree::canSplit(CellId cell, std::size_t axis) const {
  return boxes_[cell][axis].high - boxes_[cell][axis].low >= 2;
}

bool CellTree::areNeighbours(CellId a, CellId b) const {
  const Contact contact = contactOf(boxes_[a], boxes_[b]);
  return contact.is_face && (contact.axis != kYaw || joins_headings_);
}

void CellTree::addNeighbour(CellId cell, CellId other) {
  Row& row = rows_[cell];
  if (row.count == row.room) {
    const auto begin = static_cast<std::uint32_t>(pool_.size());
    const std::uint32_t room = std::max(16U, 2 * row.room);
    pool_.resize(pool_.size() + room);
    std::copy_n(pool_.begin() + row.begin, row.count, pool_.begin() + begin);
    row.begin = begin;
    row.room = room;
  }
  pool_[row.begin + row.count++] = other;
}

void CellTree::dropNeighbour(CellId cell, CellId other) {
  Row& row = rows_[cell];
  const auto begin = pool_.begin() + row.begin;
  const auto at = std::find(begin, begin + row.count, other);
  *at = *(begin + --row.count);
}

CellId CellTree::halve(CellId cell, std::size_t axis) {
  const UnitRange range = boxes_[cell][axis];
  const Units middle = range.low + (range.high - range.low) / 2;
  const auto upper = static_cast<CellId>(boxes_.size());
  const auto branch = static_cast<std::uint32_t>(branches_.size());
  branches_.push_back({axis, middle, cell | kLeaf, upper | kLeaf});
  const Site site = sites_[cell];
  (site.is_above ? branches_[site.branch].above : branches_[site.branch].below) = branch;
  sites_[cell] = {branch, false};
  sites_.push_back({branch, true});
  boxes_.push_back(boxes_[cell]);
  rows_.emplace_back();
  boxes_[cell][axis].high = middle;
  boxes_[upper][axis].low = middle;
  return upper;
}

CellId CellTree::split(CellId cell, std::size_t axis) {
  const auto row = neighbours(cell);
  const std::vector<CellId> before(row.begin(), row.end());
  const CellId upper = halve(cell, axis);
  rows_[cell].count = 0;
  for (const CellId other : before) {
    if (areNeighbours(cell, other))
      addNeighbour(cell, other);
    else
      dropNeighbour(other, cell);
    if (areNeighbours(upper, other)) addNeighbour(upper, other), addNeighbour(other, upper);
  }
  if (areNeighbours(cell, upper)) addNeighbour(cell, upper), addNeighbour(upper, cell);
  return upper;
}

void CellTree::findTouching(const CellBox& box, std::vector<CellId>& found) const {
  for (const Units turned : {-kWholeAxis, 0, kWholeAxis}) {
    CellBox wanted = box;
    wanted[kYaw] = {box[kYaw].low + turned, box[kYaw].high + turned};
    if (!meet(wanted[kYaw], {})) continue;
    std::array<std::uint32_t, kDeepest> open{branches_[0].above};
    std::size_t count = 1;
    while (count > 0) {
      const std::uint32_t at = open[--count];
      if ((at & kLeaf) != 0) {
        found.push_back(at & ~kLeaf);
        continue;
      }
      const Branch& branch = branches_[at];
      if (wanted[branch.axis].low <= branch.at) open[count++] = branch.below;
      if (wanted[branch.axis].high >= branch.at) open[count++] = branch.above;
    }
  }
}

}  // namespace underway::proof
