#include "planner/roadmap_flaw.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/world.hpp"

namespace underway {
namespace {

constexpr double kExact = 1e-9;  // of positions [m] and headings [rad]
constexpr double kLongestCrossing_m =
    1000.0;  // far beyond what grows; what it costs fits its field (cost.hpp)

bool isNear(const Pose& a, const Pose& b) {
  return distance(a.position(), b.position()) <= kExact && std::abs(normalizedAngle(a.yaw - b.yaw)) <= kExact;
}

bool isSane(Point at) { return std::abs(at.x) <= World::kLargest_m && std::abs(at.y) <= World::kLargest_m; }
bool isSane(const Pose& pose) {
  return isSane(pose.position()) && std::abs(pose.yaw) <= 2.0 * std::numbers::pi;
}

bool leadsThere(const Robot& robot, const Motion& motion) {
  switch (motion.kind) {
    case MotionKind::kTranslate:
      return robot.modes[motion.mode].canMove(motion.sense) && motion.from.yaw == motion.to.yaw &&
             isNear(translate(motion.mode, motion.sense, motion.from, length(motion)).to, motion.to);
    case MotionKind::kTurn:
      return robot.modes[motion.mode].canTurn() && motion.from.position() == motion.to.position() &&
             std::abs(motion.angle_rad) <= 2.0 * std::numbers::pi &&
             std::abs(normalizedAngle(motion.from.yaw + motion.angle_rad - motion.to.yaw)) <= kExact;
    case MotionKind::kSwitch: {
      const Switch* change = robot.findSwitch(motion.mode, motion.to_mode);
      return change != nullptr && isNear(compose(motion.from, change->displacement), motion.to);
    }
  }
  return false;
}

class Inspection {
 public:
  Inspection(const Roadmap& roadmap, const Stances& stances, const Robot& robot)
      : roadmap_(roadmap), stances_(stances), robot_(robot), is_taken_(roadmap.crossings.size(), 0) {}

  std::optional<std::string> flaw() {
    if (roadmap_.ways.size() != roadmap_.links.size()) return "links and ways differ in number";
    Roadmap::LinkId next = 0;
    for (Roadmap::PlaceId id = 0; id < roadmap_.places.size(); ++id) {
      const Roadmap::Place& place = roadmap_.places[id];
      if (!isGood(place) || std::exchange(next, place.end_link) != place.first_link)
        return fmt::format("place {} is none of this robot's", id);
      if (place.end_link < place.first_link || place.end_link > roadmap_.links.size())
        return fmt::format("place {} has links that are not there", id);
    }
    if (next != roadmap_.links.size()) return "there are links of no place";
    for (Roadmap::LinkId id = 0; id < roadmap_.links.size(); ++id)
      if (!isGood(id)) return fmt::format("link {} does not join its places", id);
    if (std::find(is_taken_.begin(), is_taken_.end(), 0) != is_taken_.end())
      return "there are crossings of no link";
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool isGood(const Roadmap::Place& place) const {
    return isSane(place.at) && place.group < stances_.groups().modes.size() &&
           place.keep_m == robot_.margin_m;
  }

  bool isGood(Roadmap::LinkId id) {
    const Roadmap::Link& link = roadmap_.links[id];
    const auto count = static_cast<Roadmap::PlaceId>(roadmap_.places.size());
    if (link.from >= count || link.to >= count) return false;
    const Roadmap::Place& from = roadmap_.places[link.from];
    if (id < from.first_link || id >= from.end_link) return false;
    if ((roadmap_.ways[id] & ~link.tried) != 0) return false;
    return link.crossing == Roadmap::kNone ? areGoodLegs(id) : isGoodCrossing(link);
  }

  [[nodiscard]] bool areGoodLegs(Roadmap::LinkId id) const {
    const Roadmap::Link& link = roadmap_.links[id];
    const Roadmap::Place& from = roadmap_.places[link.from];
    const Roadmap::Place& to = roadmap_.places[link.to];
    const std::size_t ways = stances_.ofGroup(from.group).ways().size();
    if (from.group != to.group || link.tried != (Roadmap::Ways{1} << ways) - 1U || !(link.length_m > 0.0))
      return false;
    if (link.twin >= roadmap_.links.size()) return false;
    const Roadmap::Link& twin = roadmap_.links[link.twin];
    return twin.twin == id && twin.crossing == Roadmap::kNone && twin.from == link.to && twin.to == link.from;
  }

  bool isGoodCrossing(const Roadmap::Link& link) {
    if (link.twin != Roadmap::kNone || link.tried != 1 || link.crossing >= roadmap_.crossings.size())
      return false;
    if (std::exchange(is_taken_[link.crossing], 1) != 0) return false;  // two links never share one
    const Crossing& crossing = roadmap_.crossings[link.crossing];
    double way_m = 0.0;
    for (const Motion& motion : crossing.motions) way_m += length(motion);
    const Roadmap::Place& from = roadmap_.places[link.from];
    const Roadmap::Place& to = roadmap_.places[link.to];
    return way_m <= kLongestCrossing_m && crossing.entry().position() == from.at &&
           crossing.exit().position() == to.at && stances_.groupOf(crossing.entryMode()) == from.group &&
           stances_.groupOf(crossing.exitMode()) == to.group;
  }

  const Roadmap& roadmap_;
  const Stances& stances_;
  const Robot& robot_;
  std::vector<char> is_taken_;  // by crossing
};

}  // namespace

bool isLegal(const Robot& robot, const Motion& motion) {
  if (motion.mode >= robot.modes.size() || motion.to_mode >= robot.modes.size()) return false;
  if ((motion.kind != MotionKind::kSwitch && motion.mode != motion.to_mode) || motion.sense > Sense::kRight)
    return false;
  if ((motion.kind != MotionKind::kTranslate && motion.sense != Sense::kForward) ||
      (motion.kind != MotionKind::kTurn && motion.angle_rad != 0.0))
    return false;
  if (!isSane(motion.from) || !isSane(motion.to) || !std::isfinite(motion.angle_rad)) return false;
  return leadsThere(robot, motion) && std::isfinite(duration(robot, motion));
}

std::optional<std::string> flawIn(const Roadmap& roadmap, const Stances& stances, const Robot& robot) {
  return Inspection(roadmap, stances, robot).flaw();
}

}  // namespace underway
