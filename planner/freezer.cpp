#include "planner/freezer.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <stdexcept>

namespace underway {
namespace {

/// Order of headings in a place: counter-clockwise from -pi.
bool comesBefore(double a, double b) {
  const double na = normalizedAngle(a);
  const double nb = normalizedAngle(b);
  return na < nb || (na == nb && a < b);
}

void sortHeadings(std::vector<double>& headings) {
  std::sort(headings.begin(), headings.end(), comesBefore);
  headings.erase(std::unique(headings.begin(), headings.end()), headings.end());
}

}  // namespace

Freezer::Freezer(const Draft& draft, const Checker& checker, Draft::Check check, Interrupt& interrupt)
    : draft_(draft), checker_(checker), check_(check), interrupt_(interrupt) {}

std::optional<Roadmap> Freezer::freeze() {
  roadmap_.base = draft_.base_;
  shareHeadingsOfTwins();
  addNodes();
  addLinks();
  addTwinSwitches();
  addTurns();
  if (!dropBlocked()) return std::nullopt;
  pack();
  if (!roadmap_.base) indexPlaces();
  return std::move(roadmap_);
}

void Freezer::shareHeadingsOfTwins() {
  for (const Draft::Own& own : draft_.own_) own_headings_.push_back(own.headings);
  for (const auto& [first, second] : draft_.twins_) {
    const std::vector<double>& from = own_headings_[second - draft_.first_own_];
    std::vector<double>& to = own_headings_[first - draft_.first_own_];
    to.insert(to.end(), from.begin(), from.end());
  }
  for (std::vector<double>& headings : own_headings_) sortHeadings(headings);
}

void Freezer::addNodes() {
  const NodeId first = roadmap_.baseNodes();
  const auto next = [&] { return first + static_cast<NodeId>(roadmap_.nodes.size()); };
  for (std::size_t i = 0; i < draft_.own_.size(); ++i) {
    Roadmap::Place place = draft_.own_[i].place;
    const auto id = draft_.first_own_ + static_cast<PlaceId>(i);
    place.first_node = next();
    for (const double yaw : own_headings_[i])
      roadmap_.nodes.push_back({{place.at.x, place.at.y, yaw}, place.mode, id});
    place.end_node = next();
    roadmap_.places.push_back(place);
  }
  for (const auto& [id, headings] : draft_.base_headings_) added_to_base_[id];
  for (auto& [id, nodes] : added_to_base_) {  // by number: the same order every time
    std::vector<double> headings = draft_.base_headings_.at(id);
    sortHeadings(headings);
    const Roadmap::Place& place = roadmap_.place(id);
    for (const double yaw : headings) {
      bool known = false;
      for (NodeId n = place.first_node; n < place.end_node; ++n) known |= roadmap_.node(n).pose.yaw == yaw;
      if (known) continue;
      nodes.push_back(next());
      roadmap_.nodes.push_back({{place.at.x, place.at.y, yaw}, place.mode, id});
    }
  }
}

std::vector<Roadmap::NodeId> Freezer::ringOf(PlaceId id) const {
  const Roadmap::Place& place = roadmap_.place(id);
  std::vector<NodeId> ring(place.end_node - place.first_node);
  std::iota(ring.begin(), ring.end(), place.first_node);
  const auto added = added_to_base_.find(id);
  if (added == added_to_base_.end()) return ring;
  ring.insert(ring.end(), added->second.begin(), added->second.end());
  std::sort(ring.begin(), ring.end(), [&](NodeId a, NodeId b) {
    return comesBefore(roadmap_.node(a).pose.yaw, roadmap_.node(b).pose.yaw);
  });
  return ring;
}

Roadmap::NodeId Freezer::nodeAt(PlaceId id, double yaw) const {
  if (const auto node = findNode(roadmap_, id, yaw)) return *node;
  for (const NodeId node : added_to_base_.at(id))
    if (roadmap_.node(node).pose.yaw == yaw) return node;
  throw std::logic_error("a connection's heading is missing in its place");
}

std::optional<std::size_t> Freezer::ask(NodeId from, const Roadmap::Edge& edge) {
  if (!edge.checked) return std::nullopt;
  asked_.push_back(motionOf(roadmap_, checker_.robot(), from, edge));
  return asked_.size() - 1;
}

bool Freezer::dropBlocked() {
  constexpr std::size_t kInACall = 1024;  // some tens of microseconds between looks at the deadline
  std::vector<char> free;
  free.reserve(asked_.size());
  const std::span<const Motion> all(asked_);
  for (std::size_t i = 0; i < all.size(); i += kInACall) {
    if (interrupt_.isDueNow()) return false;
    const auto some =
        checker_.areFree(all.subspan(i, std::min(kInACall, all.size() - i)), checker_.robot().margin_m);
    free.insert(free.end(), some.begin(), some.end());
  }
  std::erase_if(outgoing_, [&](const Outgoing& out) { return out.asked && free[*out.asked] == 0; });
  return !interrupt_.isDueNow();
}

void Freezer::addSwitch(NodeId from, NodeId to) {
  const Roadmap::Edge edge{to, MotionKind::kSwitch, {}, false, check_ == Draft::Check::kNow};
  outgoing_.push_back({from, edge, ask(from, edge)});
}

void Freezer::addLinks() {
  for (const Draft::Link& link : draft_.links_) {
    const NodeId from = nodeAt(link.from, link.from_yaw);
    const NodeId to = nodeAt(link.to, link.to_yaw);
    if (link.kind == MotionKind::kSwitch)
      addSwitch(from, to);
    else
      outgoing_.push_back({from, {to, link.kind, link.sense, false, check_ == Draft::Check::kNow}, {}});
  }
}

void Freezer::addTwinSwitches() {
  const Robot& robot = checker_.robot();
  for (const auto& [first, second] : draft_.twins_) {
    const bool there = robot.findSwitch(draft_.modeOf(first), draft_.modeOf(second)) != nullptr;
    const bool back = robot.findSwitch(draft_.modeOf(second), draft_.modeOf(first)) != nullptr;
    for (const double yaw : own_headings_[second - draft_.first_own_]) {
      const NodeId a = nodeAt(first, yaw);
      const NodeId b = nodeAt(second, yaw);
      if (there) addSwitch(a, b);
      if (back) addSwitch(b, a);
    }
  }
}

void Freezer::addTurns() {
  for (PlaceId i = 0; i < roadmap_.places.size(); ++i)
    addTurnsOf(roadmap_.basePlaces() + i, ringOf(roadmap_.basePlaces() + i));
  for (const auto& [place, added] : added_to_base_)
    if (!added.empty()) addTurnsOf(place, ringOf(place));
}

void Freezer::addTurnsOf(PlaceId id, const std::vector<NodeId>& ring) {
  const Roadmap::Place& place = roadmap_.place(id);
  if (ring.size() < 2 || !checker_.robot().modes[place.mode].canTurn()) return;
  const bool turns_freely =
      check_ == Draft::Check::kNow && checker_.isFreeAllRound(place.mode, place.at, place.keep_m);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const NodeId a = ring[i];
    const NodeId b = ring[(i + 1) % ring.size()];
    const bool known = a < roadmap_.baseNodes() && b < roadmap_.baseNodes();
    if (!known) addBothTurns(a, b, turns_freely);
  }
}

void Freezer::addBothTurns(NodeId a, NodeId b, bool turns_freely) {
  const Roadmap::Edge left{b, MotionKind::kTurn, {}, false, check_ == Draft::Check::kNow};
  const Roadmap::Edge right{a, MotionKind::kTurn, {}, true, check_ == Draft::Check::kNow};
  const auto asked = turns_freely ? std::nullopt : ask(a, left);
  outgoing_.push_back({a, left, asked});
  outgoing_.push_back({b, right, asked});
}

void Freezer::pack() {
  const NodeId first = roadmap_.baseNodes();
  roadmap_.first_edge.assign(roadmap_.nodes.size() + 1, 0);
  for (const Outgoing& out : outgoing_)
    if (out.from >= first) ++roadmap_.first_edge[out.from - first + 1];
  std::partial_sum(roadmap_.first_edge.begin(), roadmap_.first_edge.end(), roadmap_.first_edge.begin());
  std::vector<std::uint32_t> next(roadmap_.first_edge.begin(), roadmap_.first_edge.end() - 1);
  roadmap_.edges.resize(roadmap_.first_edge.back());
  for (const Outgoing& out : outgoing_) {
    if (out.from >= first)
      roadmap_.edges[next[out.from - first]++] = out.edge;
    else
      roadmap_.edges_from_base[out.from].push_back(out.edge);
  }
}

std::vector<std::uint32_t> Freezer::sizesOfParts() const {
  std::vector<PlaceId> parent(roadmap_.places.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root_of = [&](PlaceId place) {
    while (parent[place] != place) place = parent[place] = parent[parent[place]];
    return place;
  };
  for (const Outgoing& out : outgoing_)
    parent[root_of(roadmap_.node(out.from).place)] = root_of(roadmap_.node(out.edge.to).place);
  std::vector<std::uint32_t> count(parent.size(), 0);
  for (PlaceId place = 0; place < parent.size(); ++place) ++count[root_of(place)];
  std::vector<std::uint32_t> sizes(parent.size());
  for (PlaceId place = 0; place < parent.size(); ++place) sizes[place] = count[root_of(place)];
  return sizes;
}

void Freezer::indexPlaces() {
  constexpr std::uint32_t kSmallPart = 40;
  const std::vector<std::uint32_t> sizes = sizesOfParts();
  std::vector<PlaceIndex::Entry> all;
  std::vector<PlaceIndex::Entry> in_large_parts;
  for (PlaceId id = 0; id < roadmap_.places.size(); ++id) {
    const Roadmap::Place& place = roadmap_.places[id];
    all.push_back({place.at, place.mode, id});
    if (sizes[id] >= kSmallPart) in_large_parts.push_back(all.back());
  }
  roadmap_.index = PlaceIndex(std::move(all));
  roadmap_.main_index = PlaceIndex(std::move(in_large_parts));
}

}  // namespace underway
