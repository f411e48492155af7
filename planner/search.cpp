#include "planner/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace underway {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A way to reach a node, found but not settled yet.
struct Arrival {
  Cost bound;  // cost so far plus the least that is left
  Cost cost;
  Roadmap::NodeId node = 0;
  std::uint32_t parent = 0;             // arrival it came from
  const Roadmap::Edge* edge = nullptr;  // null at the start
};

/// Puts the cheapest bound first; of equal ones the earlier arrival.
struct IsWorse {
  const std::vector<Arrival>& arrivals;
  bool operator()(std::uint32_t a, std::uint32_t b) const {
    const Cost ca = arrivals[a].bound;
    const Cost cb = arrivals[b].bound;
    return ca > cb || (ca == cb && a > b);
  }
};

double highestSpeed(const Robot& robot) {
  double fastest = 0.0;
  for (const Mode& mode : robot.modes)
    for (const double speed : mode.speed_mps) fastest = std::max(fastest, speed);
  for (const Switch& change : robot.switches) {
    const double moved = std::hypot(change.displacement.x, change.displacement.y);
    if (moved > 0.0)
      fastest = std::max(fastest, moved / change.duration_s);  // infinite when it takes no time
  }
  return fastest;
}

}  // namespace

bool EdgeChecks::isFree(Roadmap::NodeId from, const Roadmap::Edge& edge, double at_least_m) {
  if (edge.checked && at_least_m <= checker_.robot().margin_m) return true;
  Known& known = known_[&edge];
  if (at_least_m > known.free_at_m && at_least_m < known.blocked_at_m)
    (underway::isFree(roadmap_, checker_, from, edge, at_least_m) ? known.free_at_m : known.blocked_at_m) =
        at_least_m;
  return at_least_m <= known.free_at_m;
}

TimeBound::TimeBound(const Robot& robot, Point goal, ModeId goal_mode)
    : goal_(goal), fastest_mps_(highestSpeed(robot)), switching_s_(robot.modes.size(), kNever) {
  switching_s_[goal_mode] = 0.0;
  for (std::size_t round = 0; round < robot.modes.size(); ++round) {  // Bellman and Ford over few modes
    for (const Switch& change : robot.switches) {
      const double moved = std::hypot(change.displacement.x, change.displacement.y);
      const double standing =
          moved > 0.0 ? std::max(0.0, change.duration_s - moved / fastest_mps_) : change.duration_s;
      switching_s_[change.from] = std::min(switching_s_[change.from], standing + switching_s_[change.to]);
    }
  }
}

std::uint64_t TimeBound::us(Point from, ModeId mode) const {
  const double way = distance(from, goal_);
  const double seconds = (way > 0.0 ? way / fastest_mps_ : 0.0) + switching_s_[mode];
  constexpr double kMost_s = 1e6;  // of a robot that cannot get there, or hardly moves
  return static_cast<std::uint64_t>(std::min(seconds, kMost_s) * 1e6);
}

std::optional<std::vector<Motion>> search(const Roadmap& roadmap, const Robot& robot, EdgeChecks& checks,
                                          const Target& target, Interrupt& interrupt) {
  const Roadmap::Place& goal = roadmap.place(target.goal_place);
  const TimeBound bound(robot, goal.at, goal.mode);
  std::vector<Arrival> arrivals;
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, IsWorse> open(IsWorse{arrivals});
  std::vector<bool> is_settled(roadmap.nodeCount(), false);
  std::vector<Cost> best(roadmap.nodeCount(), Cost::most());  // by edges known to be free

  const auto arrive = [&](Roadmap::NodeId node, Cost cost, std::uint32_t parent, const Roadmap::Edge* edge) {
    if (is_settled[node] || cost >= best[node]) return;
    const bool is_certain = edge == nullptr || (edge->checked && target.at_least_m <= robot.margin_m);
    if (is_certain) best[node] = cost;
    const Roadmap::Node& at = roadmap.node(node);
    const Cost left = Cost::time(bound.us(at.pose.position(), at.mode));
    arrivals.push_back({cost + left, cost, node, parent, edge});
    open.push(static_cast<std::uint32_t>(arrivals.size() - 1));
  };
  const auto route_to = [&](std::uint32_t last) {
    std::vector<Motion> route;
    for (std::uint32_t i = last; arrivals[i].edge != nullptr; i = arrivals[i].parent)
      route.push_back(motionOf(roadmap, robot, arrivals[arrivals[i].parent].node, *arrivals[i].edge));
    std::reverse(route.begin(), route.end());
    return route;
  };

  arrive(target.start, Cost(), 0, nullptr);
  while (!open.empty() && !interrupt.isDue()) {
    const std::uint32_t index = open.top();
    open.pop();
    const Arrival here = arrivals[index];
    if (is_settled[here.node]) continue;
    if (here.edge != nullptr && !checks.isFree(arrivals[here.parent].node, *here.edge, target.at_least_m))
      continue;
    is_settled[here.node] = true;
    const bool is_goal = target.goal_node ? here.node == *target.goal_node
                                          : roadmap.node(here.node).place == target.goal_place;
    if (is_goal) return route_to(index);
    roadmap.forEachEdge(here.node, [&](const Roadmap::Edge& edge) {
      const Cost step = costOf(robot, target.policy, motionOf(roadmap, robot, here.node, edge));
      arrive(edge.to, here.cost + step, index, &edge);
    });
  }
  return std::nullopt;
}

}  // namespace underway
