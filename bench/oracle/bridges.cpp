#include "bench/oracle/bridges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/oracle/chain.hpp"

namespace underway::bench {
namespace {

/// How far a mode may go along a sense, to a cell's length [m].
double longestRun(const Lattice& lattice, const Keep& keep, ModeId mode, Sense sense, const Pose& from) {
  const Bounds& bounds = lattice.checker().world().bounds();
  const auto is_free = [&](double length_m) { return keep.isFree(translate(mode, sense, from, length_m)); };
  double blocked = std::hypot(bounds.width_m, bounds.height_m);
  double free = lattice.settings().cell_m;
  if (!is_free(free)) return 0.0;
  while (blocked - free > lattice.settings().cell_m) {
    const double middle = std::min(2.0 * free, 0.5 * (free + blocked));
    (is_free(middle) ? free : blocked) = middle;
  }
  return free;
}

/// Whether whoever walks is at least as well off as on the rail.
bool isWalkingBetter(const Lattice& lattice, GaitId walker, ModeId rail, Sense sense) {
  const auto mode = lattice.gaits().all[walker].mode(sense);
  const Robot& robot = lattice.checker().robot();
  return mode && *mode < rail && robot.modes[*mode].speed(sense) >= robot.modes[rail].speed(sense);
}

bool isFreeWalk(const Lattice& lattice, const Keep& keep, GaitId gait, Sense sense, const Pose& from,
                const Pose& to) {
  const auto mode = lattice.gaits().all[gait].mode(sense);
  return mode && keep.isFree(translate(*mode, sense, from, to.position()));
}

/// The exits of one sense of the rail through one switch.
void addExits(const Lattice& lattice, const Keep& keep, const Switch& up, Sense sense, const Pose& from,
              bool is_needed_only, std::vector<RailExit>& exits) {
  const double run_m = longestRun(lattice, keep, up.from, sense, from);
  std::optional<Pose> before;  // where the exit a cell earlier led, if that was free
  for (int i = 0; i * lattice.settings().cell_m <= run_m; ++i) {
    Route route;
    if (i > 0) route.push_back(translate(up.from, sense, from, i * lattice.settings().cell_m));
    route.push_back(switchModes(up, i > 0 ? route.back().to : from));
    if (!keep.isFree(route.back())) {
      before.reset();
      continue;
    }
    const Pose to = route.back().to;
    const GaitId gait = lattice.gaits().of_mode[up.to];
    const bool is_needed = !is_needed_only || !before || !isFreeWalk(lattice, keep, gait, sense, *before, to);
    before = to;
    if (is_needed) exits.push_back({std::move(route), to, gait});
  }
}

/// Whether a mode goes forward and nowhere else.
bool isOneWay(const Mode& mode) {
  return std::all_of(kSenses.begin(), kSenses.end(),
                     [&](Sense sense) { return mode.canMove(sense) == (sense == Sense::kForward); });
}

Cost costOfRoute(const Lattice& lattice, const Route& route) {
  return totalCost(lattice.checker().robot(), lattice.settings().policy, route);
}

/// The motions of one way to a node, as long as they are free.
class Snap {
 public:
  Snap(const Lattice& lattice, const Keep& keep, GaitId gait, const Pose& from, bool is_backwards)
      : keep_(keep), gait_(lattice.gaits().all[gait]), is_backwards_(is_backwards), at_(from) {}

  bool turnTo(double yaw) {
    if (at_.yaw == yaw) return true;
    const double angle = normalizedAngle(yaw - at_.yaw);
    if (add(turn(*gait_.turning, at_, angle, yaw), *gait_.turning)) return true;
    const double other = angle - std::copysign(2.0 * std::numbers::pi, angle);
    return add(turn(*gait_.turning, at_, other, yaw), *gait_.turning);
  }

  /// Along one of the body's axes, by a signed length.
  bool moveBy(double length_m, Sense positive, std::optional<Point> to = {}) {
    if (std::abs(length_m) < 1e-10) return true;
    const Sense sense = length_m > 0.0 ? positive : opposite(positive);
    const auto mode = gait_.mode(is_backwards_ ? opposite(sense) : sense);
    if (!mode) return false;
    return add(to ? translate(*mode, sense, at_, *to) : translate(*mode, sense, at_, std::abs(length_m)),
               *mode);
  }

  [[nodiscard]] const Pose& at() const { return at_; }
  [[nodiscard]] const Route& route() const { return route_; }

 private:
  bool add(const Motion& motion, ModeId mode) {
    const Motion done = is_backwards_ ? reversed(motion, mode) : motion;
    if (!keep_.isFree(done)) return false;
    route_.insert(is_backwards_ ? route_.begin() : route_.end(), done);
    at_ = motion.to;
    return true;
  }

  const Keep& keep_;
  const Gait& gait_;
  bool is_backwards_;
  Pose at_;
  Route route_;
};

/// The next cells ahead and behind on the heading's line through a point; empty if no cells lie on that line.
std::vector<Lattice::Cell> cellsInLine(const Heading& along, Point at) {
  const double line = along.x * at.y - along.y * at.x;
  if (std::abs(line - std::round(line)) > 1e-6) return {};
  const int reach = std::max(std::abs(along.x), std::abs(along.y));
  std::optional<Lattice::Cell> ahead, behind;
  double to_ahead = 1e9;
  double to_behind = 1e9;
  const int x0 = static_cast<int>(std::floor(at.x));
  const int y0 = static_cast<int>(std::floor(at.y));
  for (int x = x0 - reach; x <= x0 + reach + 1; ++x)
    for (int y = y0 - reach; y <= y0 + reach + 1; ++y) {
      if (along.x * y - along.y * x != static_cast<int>(std::round(line))) continue;
      const double way = along.x * (x - at.x) + along.y * (y - at.y);
      if (way >= -1e-6 && way < to_ahead) ahead = {x, y}, to_ahead = way;
      if (way <= 1e-6 && -way < to_behind) behind = {x, y}, to_behind = -way;
    }
  std::vector<Lattice::Cell> cells;
  if (ahead) cells.push_back(*ahead);
  if (behind && !(behind == ahead)) cells.push_back(*behind);
  return cells;
}

std::vector<Lattice::Cell> cellsAround(Point at) {
  const int x = static_cast<int>(std::floor(at.x));
  const int y = static_cast<int>(std::floor(at.y));
  return {{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}};
}

}  // namespace

std::vector<RailExit> railExits(const Lattice& lattice, const Keep& keep, ModeId rail, const Pose& from,
                                std::optional<GaitId> walker) {
  const Robot& robot = lattice.checker().robot();
  std::vector<RailExit> exits;
  for (const Switch& up : robot.switches) {
    if (up.from != rail || !lattice.gaits().of(up.to).turning) continue;
    for (const Sense sense : kSenses) {
      if (!robot.modes[rail].canMove(sense)) continue;
      const bool is_needed_only = walker && *walker == lattice.gaits().of_mode[up.to] &&
                                  isWalkingBetter(lattice, *walker, rail, sense);
      addExits(lattice, keep, up, sense, from, is_needed_only, exits);
    }
  }
  return exits;
}

std::vector<Spur> snapped(const Lattice& lattice, const Keep& keep, GaitId gait, const Pose& from,
                          int heading, bool is_backwards) {
  Snap turned(lattice, keep, gait, from, is_backwards);
  if (!turned.turnTo(lattice.yawOf(heading))) return {};
  const Point here = lattice.inCells(from.position());
  const auto in_line = cellsInLine(lattice.headings()[static_cast<std::size_t>(heading)], here);
  std::vector<Spur> spurs;
  for (const Lattice::Cell cell : in_line.empty() ? cellsAround(here) : in_line) {
    const auto node = lattice.find(gait, cell, heading);
    if (!node) continue;
    const Pose to = lattice.pose(*node);
    const Point way = transform({0.0, 0.0, -to.yaw}, {to.x - from.x, to.y - from.y});
    for (const bool is_ahead_first : {true, false}) {
      Snap snap = turned;
      const bool is_there =
          is_ahead_first
              ? snap.moveBy(way.x, Sense::kForward) && snap.moveBy(way.y, Sense::kLeft, to.position())
              : snap.moveBy(way.y, Sense::kLeft) && snap.moveBy(way.x, Sense::kForward, to.position());
      if (!is_there) continue;
      spurs.push_back({*node, snap.route(), costOfRoute(lattice, snap.route())});
      break;
    }
  }
  return spurs;
}

std::vector<Spur> bridgesFrom(Lattice& lattice, Lattice::Node node) {
  const Gaits& gaits = lattice.gaits();
  const GaitId gait = lattice.gait(node);
  const Keep keep(lattice.checker(), lattice.settings().margin_m);
  const auto further = lattice.stepped(node, static_cast<Lattice::Step>(Sense::kForward));
  std::vector<Spur> bridges;
  const auto land = [&](Route route, const Pose& pose, GaitId to) {
    for (Spur& spur : snapped(lattice, keep, to, pose, lattice.nearestHeading(pose.yaw), false)) {
      spur.route.insert(spur.route.begin(), route.begin(), route.end());
      spur.cost = costOfRoute(lattice, spur.route);
      bridges.push_back(std::move(spur));
    }
  };
  const Robot& robot = lattice.checker().robot();
  for (std::size_t i = 0; i < robot.switches.size(); ++i) {
    const Switch& down = robot.switches[i];
    const GaitId to = gaits.of_mode[down.to];
    if (gaits.of_mode[down.from] != gait || to == gait || !lattice.maySwitch(node, i)) continue;
    const bool is_rail = !gaits.all[to].turning;
    if (is_rail && further && isOneWay(robot.modes[down.to]) &&
        isWalkingBetter(lattice, gait, down.to, Sense::kForward) && lattice.maySwitch(*further, i))
      continue;
    const Motion motion = switchModes(down, lattice.pose(node));
    if (!is_rail) {
      land({motion}, motion.to, to);
      continue;
    }
    for (RailExit& exit : railExits(lattice, keep, down.to, motion.to, gait)) {
      exit.route.insert(exit.route.begin(), motion);
      land(std::move(exit.route), exit.pose, exit.gait);
    }
  }
  return bridges;
}

}  // namespace underway::bench
