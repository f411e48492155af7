#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace underway::proof {

using CellId = std::uint32_t;
/// Whole numbers, so that neighbours agree on where they meet: an axis is kWholeAxis long.
using Units = std::int32_t;
inline constexpr Units kWholeAxis = 1 << 24;

/// x, y and yaw, by index.
inline constexpr std::size_t kX = 0;
inline constexpr std::size_t kY = 1;
inline constexpr std::size_t kYaw = 2;

struct UnitRange {
  Units low = 0;
  Units high = kWholeAxis;
  bool operator==(const UnitRange&) const = default;
};
/// A closed box of poses.
using CellBox = std::array<UnitRange, 3>;

/// How two cells lie to each other: apart, or across one axis.
struct Contact {
  bool is_face = false;     ///< they share part of a face
  std::size_t axis = kX;    ///< across it
  bool is_upwards = false;  ///< the second lies on the side of larger numbers
};
[[nodiscard]] Contact contactOf(const CellBox& from, const CellBox& to);

/// All poses over a floor, cut into cells that are halved where it matters. Yaw is a circle. Cells know the
/// ones they share a face with.
class CellTree {
 public:
  /// Eight slices of yaw. `joins_headings`: cells are also neighbours across yaw.
  explicit CellTree(bool joins_headings);

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] const CellBox& box(CellId cell) const { return boxes_[cell]; }
  /// In no particular order; until the next split.
  [[nodiscard]] std::span<const CellId> neighbours(CellId cell) const {
    return {pool_.data() + rows_[cell].begin, rows_[cell].count};
  }

  [[nodiscard]] bool canSplit(CellId cell, std::size_t axis) const;
  /// Halves a cell: it keeps the lower half, and the upper one is returned.
  CellId split(CellId cell, std::size_t axis);

  /// Appends the cells that touch a box, whose yaw may reach beyond the axis' ends; some may come twice.
  void findTouching(const CellBox& box, std::vector<CellId>& found) const;

 private:
  struct Branch {
    std::size_t axis;
    Units at;
    std::uint32_t below;  // index of a branch, or a leaf's cell with kLeaf set
    std::uint32_t above;
  };
  struct Row {  // of neighbours, in pool_
    std::uint32_t begin = 0;
    std::uint32_t count = 0;
    std::uint32_t room = 0;
  };
  struct Site {  // where the reference to a leaf is
    std::uint32_t branch;
    bool is_above;
  };
  static constexpr std::uint32_t kLeaf = 1U << 31;

  [[nodiscard]] bool areNeighbours(CellId a, CellId b) const;
  void addNeighbour(CellId cell, CellId other);
  void dropNeighbour(CellId cell, CellId other);
  CellId halve(CellId cell, std::size_t axis);

  bool joins_headings_;
  std::vector<CellBox> boxes_;
  std::vector<Site> sites_;
  std::vector<Row> rows_;
  std::vector<CellId> pool_;
  std::vector<Branch> branches_;
};

}  // namespace underway::proof
