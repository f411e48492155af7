#pragma once

#include <map>
#include <optional>
#include <vector>

#include "planner/draft.hpp"

namespace underway {

/// Turns a draft into a roadmap, in the order a reader would: twins share their headings, headings become
/// nodes, connections become edges, turns join neighbouring headings, edges are packed by the node they
/// leave.
class Freezer {
 public:
  Freezer(const Draft& draft, const Checker& checker, Draft::Check check, Interrupt& interrupt);
  [[nodiscard]] std::optional<Roadmap> freeze();

 private:
  using NodeId = Roadmap::NodeId;
  using PlaceId = Roadmap::PlaceId;
  struct Outgoing {
    NodeId from;
    Roadmap::Edge edge;
  };

  void shareHeadingsOfTwins();
  void addNodes();
  void addLinks();
  void addTwinSwitches();
  void addTurns();
  void addTurnsOf(PlaceId place, const std::vector<NodeId>& ring);
  void addBothTurns(NodeId a, NodeId b, bool turns_freely);
  void addSwitch(NodeId from, NodeId to);
  void pack();
  void indexPlaces();
  /// For each own place, how many places are joined with it, taking edges both ways.
  [[nodiscard]] std::vector<std::uint32_t> sizesOfParts() const;
  /// Keeps an edge unless it is to be checked now and is not free.
  void keepIfFree(NodeId from, Roadmap::Edge edge);

  [[nodiscard]] NodeId nodeAt(PlaceId place, double yaw) const;
  [[nodiscard]] std::vector<NodeId> ringOf(PlaceId place) const;

  const Draft& draft_;
  const Checker& checker_;
  Draft::Check check_;
  Interrupt& interrupt_;
  Roadmap roadmap_;
  std::vector<std::vector<double>> own_headings_;         // by own place
  std::map<PlaceId, std::vector<NodeId>> added_to_base_;  // new nodes at the base's places
  std::vector<Outgoing> outgoing_;
};

}  // namespace underway
