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
    std::optional<std::size_t> asked;  // the motion that must turn out free
  };

  void shareHeadingsOfTwins();
  void addNodes();
  void addLinks();
  void addTwinSwitches();
  void addTurns();
  void addTurnsOf(PlaceId place, const std::vector<NodeId>& ring);
  void addBothTurns(NodeId a, NodeId b, bool turns_freely);
  void addSwitch(NodeId from, NodeId to);
  /// Checks all motions that were asked about, in a few calls, and drops the edges of those that are not
  /// free. False when interrupted.
  [[nodiscard]] bool dropBlocked();
  void pack();
  void indexPlaces();
  /// For each own place, how many places are joined with it, taking edges both ways.
  [[nodiscard]] std::vector<std::uint32_t> sizesOfParts() const;
  /// Asks about the motion of an edge that is to be checked now.
  [[nodiscard]] std::optional<std::size_t> ask(NodeId from, const Roadmap::Edge& edge);

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
  std::vector<Motion> asked_;
};

}  // namespace underway
