#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "planner/roadmap.hpp"
#include "planner/stances.hpp"

namespace underway {

/// Which places and links of a roadmap a change in the world may touch: an index from space to links. It holds
/// for all roadmaps with the same places and links. Never changed once made.
class LinkIndex {
 public:
  LinkIndex(const Roadmap& roadmap, const Robot& robot);

  /// An axis-aligned region of the map [m].
  struct Region {
    double min_x = 0.0;
    double min_y = 0.0;
    double max_x = 0.0;
    double max_y = 0.0;
  };
  /// Calls link(id) and place(id) for what the robot might touch a region from; some may come twice.
  template <class VisitLink, class VisitPlace>
  void visit(const Region& region, const VisitLink& visit_link, const VisitPlace& visit_place) const {
    visitCells(region, [&](std::size_t cell) {
      for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
        const std::uint32_t entry = entries_[i];
        if (!areApart(boxes_[entry], region))
          entry < places_ ? visit_place(entry) : visit_link(entry - places_);
      }
    });
  }

 private:
  template <class Visit>
  void visitCells(const Region& region, const Visit& visit) const {
    const auto cell = [&](double at, double origin, std::size_t count) {
      return static_cast<std::size_t>(
          std::clamp(std::floor((at - origin) / cell_m_), 0.0, static_cast<double>(count - 1)));
    };
    const std::size_t left = cell(region.min_x, min_x_, columns_);
    const std::size_t right = cell(region.max_x, min_x_, columns_);
    const std::size_t low = cell(region.min_y, min_y_, rows_);
    const std::size_t high = cell(region.max_y, min_y_, rows_);
    for (std::size_t row = low; row <= high; ++row)
      for (std::size_t column = left; column <= right; ++column) visit(row * columns_ + column);
  }
  [[nodiscard]] static bool areApart(const Region& a, const Region& b) {
    return a.min_x > b.max_x || b.min_x > a.max_x || a.min_y > b.max_y || b.min_y > a.max_y;
  }

  std::uint32_t places_ = 0;           // entries below this are places, the others links
  std::vector<Region> boxes_;          // what the robot may cover there, its margin included
  double min_x_ = 0.0;
  double min_y_ = 0.0;
  double cell_m_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> first_;   // of each cell; one more at the end
  std::vector<std::uint32_t> entries_;
};

/// What a repair looked at and found.
struct Repair {
  std::uint64_t checked = 0;  ///< links
  std::uint64_t closed = 0;   ///< ways of links that are no longer free
  std::uint64_t opened = 0;   ///< ways that have become free
};

/// The roadmap for another revision of the world: the same places and links, with the ways that are free there.
/// Only what the changes may touch is looked at again. `stances` are of the new revision.
[[nodiscard]] std::shared_ptr<const Roadmap> repaired(const Roadmap& before, const LinkIndex& index,
                                                      const Stances& stances, const Checker& after,
                                                      std::span<const Obstacles::Change> changes, Repair& repair);

/// The same, looking at everything again.
[[nodiscard]] std::shared_ptr<const Roadmap> revalidated(const Roadmap& before, const Stances& stances,
                                                         const Checker& after, Repair& repair);

}  // namespace underway
