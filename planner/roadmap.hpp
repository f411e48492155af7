#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/checker.hpp"
#include "planner/crossing.hpp"
#include "planner/groups.hpp"
#include "planner/place_index.hpp"

namespace underway {

/// The frozen multimodal roadmap in flat arrays. Never changed once made; any number of threads may read it.
///
/// A place is a position where the robot stands in one of a group's modes. Two places of a group are joined
/// by legs, one link each way: straight from one to the other, by any way (mode and sense) that is free; the
/// way fixes the heading. A search's states are so the pairs of link and way, poses in a mode; turns and
/// changes of mode at a place are worked out between the ways that meet there. A crossing is a link too, with
/// motions of its own.
struct Roadmap {
  using PlaceId = std::uint32_t;
  using LinkId = std::uint32_t;
  using Ways = std::uint32_t;  ///< a bit for each of Legs::ways()
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Place {
    Point at;  ///< map frame [m]
    GroupId group = 0;
    bool turns_freely = false;  ///< with the margin, judged by the circle round the body
    double keep_m = 0.0;  ///< clearance kept on motions that begin or end here [m]; the margin, or less where
                          ///< a start or goal is closer than that itself
    LinkId first_link = 0;
    LinkId end_link = 0;
  };
  struct Link {
    PlaceId from = 0;
    PlaceId to = 0;
    LinkId twin = kNone;             ///< the legs back; none of a crossing
    std::uint32_t crossing = kNone;  ///< index into `crossings`; none of legs
    double direction_rad = 0.0;      ///< of legs, in the map frame
    double length_m = 0.0;           ///< of legs
    Ways tried = 0;                  ///< that the modes have; a crossing has bit 0
  };

  std::vector<Place> places;
  std::vector<Link> links;  ///< ordered by the place they leave
  std::vector<Ways> ways;   ///< of each link, those that are free
  std::vector<Crossing> crossings;
  std::vector<LinkId> crossings_in;     ///< links that are crossings, ordered by the place they lead to
  std::vector<std::uint32_t> first_in;  ///< of each place into crossings_in; one more at the end
  std::uint32_t batches = 0;            ///< of growth it holds
  PlaceIndex index;                     ///< finds places by position
  PlaceIndex
      main_index;  ///< the same, without small parts that nothing joins to the rest: pockets in clutter

  std::uint64_t node_count = 0;  ///< poses in a mode that its links lead to
  std::uint64_t edge_count = 0;  ///< ways on from each of them, changes at the place included
  /// Works out the counts from `ways`.
  void count();
};

/// Whether a motion is free keeping a clearance [m]. At the margin and above the body grows by it to all four
/// sides; below, where a start or goal is closer than the margin itself, nothing may come nearer than the
/// clearance.
[[nodiscard]] bool isFreeKeeping(const Checker& checker, const Motion& motion, double keep_m);

/// The clearance to keep on motions that begin or end at a pose: the margin, or what the pose itself keeps if
/// less.
[[nodiscard]] double clearanceToKeep(const Checker& checker, ModeId mode, const Pose& pose);

}  // namespace underway
