#include "planner/roadmap.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/checker.hpp"

namespace underway {
namespace {

constexpr double kRounding_m = 1e-8;  // of clearances, which are told within a few nanometres

}  // namespace

Motion motionOf(const Roadmap& roadmap, const Robot& robot, Roadmap::NodeId from, const Roadmap::Edge& edge) {
  const Roadmap::Node& a = roadmap.node(from);
  const Roadmap::Node& b = roadmap.node(edge.to);
  switch (edge.kind) {
    case MotionKind::kTranslate:
      return translate(a.mode, edge.sense, a.pose, b.pose.position());
    case MotionKind::kTurn: {
      const double angle = edge.clockwise ? -counterClockwise(b.pose.yaw, a.pose.yaw)
                                          : counterClockwise(a.pose.yaw, b.pose.yaw);
      return turn(a.mode, a.pose, angle, b.pose.yaw);
    }
    case MotionKind::kSwitch:
      break;
  }
  Motion change = switchModes(*robot.findSwitch(a.mode, b.mode), a.pose);
  change.to = b.pose;
  return change;
}

std::optional<Roadmap::NodeId> findNode(const Roadmap& roadmap, Roadmap::PlaceId id, double yaw) {
  const Roadmap::Place& place = roadmap.place(id);
  for (Roadmap::NodeId node = place.first_node; node < place.end_node; ++node)
    if (roadmap.node(node).pose.yaw == yaw) return node;
  return std::nullopt;
}

bool isFree(const Roadmap& roadmap, const Checker& checker, Roadmap::NodeId from, const Roadmap::Edge& edge,
            double at_least_m) {
  const Robot& robot = checker.robot();
  const double keep = std::min(roadmap.place(roadmap.node(from).place).keep_m,
                               roadmap.place(roadmap.node(edge.to).place).keep_m);
  return isFreeKeeping(checker, motionOf(roadmap, robot, from, edge),
                       keep < robot.margin_m ? keep : std::max(keep, at_least_m));
}

bool isFreeKeeping(const Checker& checker, const Motion& motion, double keep_m) {
  const double margin = checker.robot().margin_m;
  if (keep_m >= margin) return checker.isFree(motion, keep_m);
  return checker.isFree(motion, 0.0) && checker.closeness(motion, margin).clearance_m >= keep_m - kRounding_m;
}

double clearanceToKeep(const Checker& checker, ModeId mode, const Pose& pose) {
  const double margin = checker.robot().margin_m;
  const Motion standing = stay(mode, pose);
  if (checker.isFree(standing, margin)) return margin;
  // A corner can be within the grown body and yet further than the margin: just below it, distances decide.
  return std::min(checker.closeness(standing, margin).clearance_m, std::nextafter(margin, 0.0));
}

}  // namespace underway
