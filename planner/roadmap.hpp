#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/checker.hpp"
#include "geometry/motion.hpp"
#include "planner/place_index.hpp"

namespace underway {

/// The frozen multimodal roadmap: a directed graph over (pose, mode) in flat arrays. Never changed once made;
/// any number of threads may read it.
///
/// A node is a pose in a mode; an edge is one motion. The nodes at one position in one mode form a place:
/// they are its headings, in counter-clockwise order, and turns join neighbours. So a connection between two
/// places chooses its own heading, and the cost of turning from one connection to the next is exact.
///
/// A roadmap may lie over another, adding places, headings and edges to it for one query: ids below the
/// base's counts are the base's own.
struct Roadmap {
  using NodeId = std::uint32_t;
  using PlaceId = std::uint32_t;

  struct Place {
    Point at;  ///< map frame [m]
    ModeId mode = 0;
    double keep_m = 0.0;  ///< clearance kept on motions that begin or end here [m]; the margin, or less where
                          ///< a start or goal is closer than that itself
    NodeId first_node = 0;
    NodeId end_node = 0;  ///< one past the last heading
  };
  struct Node {
    Pose pose;  ///< map frame
    ModeId mode = 0;
    PlaceId place = 0;
  };
  struct Edge {
    NodeId to = 0;
    MotionKind kind = MotionKind::kTranslate;
    Sense sense = Sense::kForward;  ///< of a translation
    bool clockwise = false;         ///< of a turn
    bool checked = true;  ///< free with the margin; else to be checked when a search wants to use it
  };

  std::vector<Place> places;
  std::vector<Node> nodes;
  std::vector<Edge> edges;                ///< ordered by the node they leave
  std::vector<std::uint32_t> first_edge;  ///< of each node; one more at the end
  std::uint32_t batches = 0;              ///< of growth it holds
  PlaceIndex index;                       ///< finds places by position
  PlaceIndex
      main_index;  ///< the same, without small parts that nothing joins to the rest: pockets in clutter

  std::shared_ptr<const Roadmap> base;                            ///< what it lies over, if anything
  std::unordered_map<NodeId, std::vector<Edge>> edges_from_base;  ///< that leave the base's nodes

  [[nodiscard]] NodeId baseNodes() const { return base ? static_cast<NodeId>(base->nodes.size()) : 0; }
  [[nodiscard]] PlaceId basePlaces() const { return base ? static_cast<PlaceId>(base->places.size()) : 0; }
  [[nodiscard]] NodeId nodeCount() const { return baseNodes() + static_cast<NodeId>(nodes.size()); }
  [[nodiscard]] const Node& node(NodeId id) const {
    return id < baseNodes() ? base->nodes[id] : nodes[id - baseNodes()];
  }
  [[nodiscard]] const Place& place(PlaceId id) const {
    return id < basePlaces() ? base->places[id] : places[id - basePlaces()];
  }
  /// The edges that leave one of this roadmap's own nodes, by its position in `nodes`.
  [[nodiscard]] std::span<const Edge> edgesFrom(NodeId own) const {
    return {edges.data() + first_edge[own], edges.data() + first_edge[own + 1]};
  }
  /// Calls visit(edge) for every edge that leaves a node, the base's included.
  template <class Visit>
  void forEachEdge(NodeId id, const Visit& visit) const {
    if (id >= baseNodes()) {
      for (const Edge& edge : edgesFrom(id - baseNodes())) visit(edge);
      return;
    }
    for (const Edge& edge : base->edgesFrom(id)) visit(edge);
    if (const auto more = edges_from_base.find(id); more != edges_from_base.end())
      for (const Edge& edge : more->second) visit(edge);
  }
};

/// The motion an edge stands for.
[[nodiscard]] Motion motionOf(const Roadmap& roadmap, const Robot& robot, Roadmap::NodeId from,
                              const Roadmap::Edge& edge);

/// The node of a place that has a heading, bit for bit.
[[nodiscard]] std::optional<Roadmap::NodeId> findNode(const Roadmap& roadmap, Roadmap::PlaceId place,
                                                      double yaw);

/// Whether an edge's motion is free, keeping the clearance of the places it joins, or `at_least_m` where that
/// is more and neither place asks for less than the margin.
[[nodiscard]] bool isFree(const Roadmap& roadmap, const Checker& checker, Roadmap::NodeId from,
                          const Roadmap::Edge& edge, double at_least_m = 0.0);

/// Whether a motion is free keeping a clearance [m]. At the margin and above the body grows by it to all four
/// sides; below, where a start or goal is closer than the margin itself, nothing may come nearer than the
/// clearance.
[[nodiscard]] bool isFreeKeeping(const Checker& checker, const Motion& motion, double keep_m);

/// The clearance to keep on motions that begin or end at a pose: the margin, or what the pose itself keeps if
/// less.
[[nodiscard]] double clearanceToKeep(const Checker& checker, ModeId mode, const Pose& pose);

}  // namespace underway
