#include "planner/proof/need.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/flatten.hpp"
#include "geometry/rectangle.hpp"
#include "geometry/sweep.hpp"

namespace underway::proof {
namespace {

/// What a body, or a switch's box, needs in one way.
struct Need {
  std::string of;
  double needs_m;
};

/// A shape, as the robot's part that it stands for.
struct Part {
  std::size_t shape;
  Motion motion;  ///< standing still, or the switch
  ModeId mode;
  std::string who;
  std::vector<Need> across;
  Need height;
};

Part partOf(const Robot& robot, ModeId id, std::size_t shape) {
  const Mode& mode = robot.modes[id];
  const double margins = 2.0 * robot.margin_m;
  Part part{shape, stay(id, {}), id, mode.name, {}, {"height", mode.body_m.z.max}};
  if (mode.canMove(Sense::kForward) || mode.canMove(Sense::kBackward))
    part.across.push_back({"width", mode.body_m.y.length() + margins});
  if (mode.canMove(Sense::kLeft) || mode.canMove(Sense::kRight))
    part.across.push_back({"width", mode.body_m.x.length() + margins});
  return part;
}

Part partOf(const Robot& robot, const Exit& exit) {
  const Switch& change = robot.switches[exit.of_switch];
  const double margins = 2.0 * robot.margin_m;
  return {exit.shape,
          switchModes(change, {}),
          std::max(change.from, change.to),
          robot.modes[change.from].name + " to " + robot.modes[change.to].name,
          {{"length", change.body_m.x.length() + margins}, {"switch", change.body_m.y.length() + margins}},
          {"switch", change.body_m.z.max}};
}

std::vector<Part> partsOf(const Robot& robot, const Stances& stances) {
  std::vector<Part> parts;
  for (std::size_t id = 0; id < robot.modes.size(); ++id)
    parts.push_back(partOf(robot, static_cast<ModeId>(id), stances.all[stances.of_mode[id]].shape));
  for (const Stance& stance : stances.all)
    for (const Exit& exit : stance.exits) parts.push_back(partOf(robot, exit));
  return parts;
}

/// Collects what one obstacle may leave too little of.
class Gauge {
 public:
  Gauge(const Checker& checker, const Stances& stances, std::size_t obstacle)
      : checker_(checker), stances_(stances), world_(checker.world()), own_(world_.obstacles()[obstacle]) {}

  std::vector<Lack> lacks() && {
    for (const Part& part : partsOf(checker_.robot(), stances_)) consider(part);
    std::stable_sort(lacks_.begin(), lacks_.end(),
                     [](const Lack& a, const Lack& b) { return a.missing_m() < b.missing_m(); });
    return std::move(lacks_);
  }

 private:
  void consider(const Part& part) {
    const Range slab = slabOf(checker_.robot(), part.motion, world_.floorZ());
    const std::vector<Point> seen = flattened(own_.box, slab);
    if (seen.empty()) return;
    if (const double underside = undersideOf(own_.box); underside > slab.min - world_.floorZ())
      add(part, part.height, underside);
    for (const Need& need : part.across) {
      add(part, need, 0.0);
      addGaps(part, need, seen);
      add(part, need, gapToBounds(seen) + checker_.robot().margin_m, std::nullopt, true);
    }
  }

  [[nodiscard]] double undersideOf(const OrientedBox& box) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners(box)) lowest = std::min(lowest, corner.z);
    return std::max(0.0, lowest - world_.floorZ());
  }

  /// To all that the part sees less than the need away.
  void addGaps(const Part& part, const Need& need, ConvexView seen) {
    const Rectangle around = rectangleAround(seen);
    const Prism near{{around.center.x, around.center.y, std::atan2(around.sin, around.cos)},
                     Range{-around.half_x, around.half_x}.grown(need.needs_m),
                     Range{-around.half_y, around.half_y}.grown(need.needs_m),
                     {}};
    stances_.shapes[part.shape].seen->visitTouched(near, [&](const Piece& piece) {
      if (piece.obstacle->id == own_.id) return false;
      const double gap =
          withCorners(piece, [&](ConvexView other) { return gapBetween(seen, other).distance_m; });
      if (gap > 0.0) add(part, need, gap, world_.obstacles().find(piece.obstacle->id));
      return false;
    });
  }

  [[nodiscard]] double gapToBounds(ConvexView seen) const {
    const auto ends = world_.bounds().corners();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const std::array<Point, 2> side{ends[i], ends[(i + 1) % ends.size()]};
      least = std::min(least, gapBetween(seen, side).distance_m);
    }
    return least;
  }

  void add(const Part& part, const Need& need, double has_m, std::optional<std::size_t> partner = {},
           bool is_beside_bounds = false) {
    if (has_m >= need.needs_m) return;
    lacks_.push_back({part.shape,
                      {own_.id, checker_.robot().modes[part.mode].name, need.of, need.needs_m, has_m},
                      part.who,
                      partner,
                      part.motion.kind == MotionKind::kSwitch,
                      is_beside_bounds});
  }

  const Checker& checker_;
  const Stances& stances_;
  const World& world_;
  const Obstacle& own_;
  std::vector<Lack> lacks_;
};

}  // namespace

std::vector<Lack> lacksAt(const Checker& checker, const Stances& stances, std::size_t obstacle) {
  return Gauge(checker, stances, obstacle).lacks();
}

std::string sentenceOf(const Lack& lack, const World& world) {
  const Blocking& b = lack.blocking;
  const std::string partner = lack.partner            ? " and " + world.obstacles()[*lack.partner].id
                              : lack.is_beside_bounds ? " and the bounds"
                                                      : "";
  return fmt::format("{} needs {:.3f} m of {}, {}{} {} {:.3f} m", lack.who, b.needs_m,
                     b.of == "switch" ? "room" : b.of, b.obstacle, partner,
                     partner.empty() ? "leaves" : "leave", b.has_m);
}

}  // namespace underway::proof
