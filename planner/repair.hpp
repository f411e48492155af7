#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "geometry/region_grid.hpp"
#include "planner/roadmap.hpp"
#include "planner/stances.hpp"

namespace underway {

/// Which places and links of a roadmap a change in the world may touch: an index from space to links. It
/// holds for all roadmaps with the same places and links. Never changed once made.
class LinkIndex {
 public:
  LinkIndex(const Roadmap& roadmap, const Robot& robot);

  /// Calls link(id) and place(id) for what the robot might touch a box from; some may come twice. Of two
  /// links that are twins, one.
  void visit(const Roadmap& roadmap, const OrientedBox& box, const std::function<void(Roadmap::LinkId)>& link,
             const std::function<void(Roadmap::PlaceId)>& place) const;

 private:
  std::uint32_t places_ = 0;  // regions below this are of places, the others of links
  std::vector<Roadmap::LinkId> links_;
  std::vector<double> reach_m_;  // of the robot to the sides of each of them; of crossings infinite
  RegionGrid covered_;           // what the robot may cover there, its margin included
};

/// What a repair looked at and found.
struct Repair {
  std::uint64_t checked = 0;  ///< links
  std::uint64_t closed = 0;   ///< ways of links that are no longer free
  std::uint64_t opened = 0;   ///< ways that have become free
};

/// The roadmap for another revision of the world: the same places and links, with the ways that are free
/// there. Only what the changes may touch is looked at again. `stances` are of the new revision.
[[nodiscard]] std::shared_ptr<const Roadmap> repaired(const Roadmap& before, const LinkIndex& index,
                                                      const Stances& stances, const Checker& after,
                                                      std::span<const Obstacles::Change> changes,
                                                      Repair& repair);

/// The same, looking at everything again.
[[nodiscard]] std::shared_ptr<const Roadmap> revalidated(const Roadmap& before, const Stances& stances,
                                                         const Checker& after, Repair& repair);

}  // namespace underway
