#include "bench/oracle/ends.hpp"

#include <algorithm>

#include "bench/oracle/chain.hpp"

namespace underway::bench {
namespace {

constexpr double kStraight_m = 0.6;  // how far the body goes straight on before it first turns
constexpr int kHeadingsTried = 3;    // to either side, where it has gone straight on

/// A way out from an end, and where it leads. Of a goal the way is gone from there to the end.
struct Stem {
  Route route;
  Pose pose;
  GaitId gait = 0;
  bool is_end = false;  ///< nothing was moved yet: it may turn to any heading
  bool turns = true;    ///< or else it must keep its heading, because any will do that it has
};

/// Straight out to every side.
void addStraight(const Lattice& lattice, const Keep& keep, GaitId gait, const Pose& end, bool is_goal,
                 std::vector<Stem>& stems) {
  const double step_m = 2.0 * lattice.settings().cell_m;
  for (const Sense sense : kSenses) {
    const auto mode = lattice.gaits().all[gait].mode(is_goal ? opposite(sense) : sense);
    if (!mode) continue;
    for (double length_m = step_m; length_m <= kStraight_m; length_m += step_m) {
      const Motion out = translate(*mode, sense, end, length_m);
      const Motion motion = is_goal ? reversed(out, *mode) : out;
      if (!keep.isFree(motion)) break;
      stems.push_back({{motion}, out.to, gait, false, true});
    }
  }
}

/// Backwards along a rail that ends at a goal, and from where it was entered.
void addRailBack(const Lattice& lattice, const Keep& keep, ModeId rail, const Pose& goal,
                 std::vector<Stem>& stems) {
  const Robot& robot = lattice.checker().robot();
  const Bounds& bounds = lattice.checker().world().bounds();
  for (const Switch& down : robot.switches)
    for (const Sense sense : kSenses) {
      if (down.to != rail || !robot.modes[rail].canMove(sense) || !lattice.gaits().of(down.from).turning)
        continue;
      for (int i = 0; i * lattice.settings().cell_m < bounds.width_m + bounds.height_m; ++i) {
        Route route;
        Pose entry = goal;
        if (i > 0) {
          route.push_back(
              reversed(translate(rail, opposite(sense), goal, i * lattice.settings().cell_m), rail));
          if (!keep.isFree(route.front())) break;
          entry = route.front().from;
        }
        const Motion motion = switchModes(down, before(entry, down.displacement));
        if (!keep.isFree(motion)) continue;
        route.insert(route.begin(), motion);
        stems.push_back({route, motion.from, lattice.gaits().of_mode[down.from], false, true});
      }
    }
}

std::vector<Stem> stemsOf(const Lattice& lattice, const Keep& keep, ModeId mode, const Pose& end,
                          bool is_goal) {
  std::vector<Stem> stems;
  const GaitId gait = lattice.gaits().of_mode[mode];
  if (lattice.gaits().all[gait].turning) {
    stems.push_back({{}, end, gait, true, true});
    addStraight(lattice, keep, gait, end, is_goal, stems);
  } else if (is_goal) {
    addRailBack(lattice, keep, mode, end, stems);
  } else {
    for (RailExit& exit : railExits(lattice, keep, mode, end, std::nullopt))
      stems.push_back({std::move(exit.route), exit.pose, exit.gait, false, true});
  }
  return stems;
}

std::vector<int> headingsOf(const Lattice& lattice, const Stem& stem) {
  const int count = lattice.settings().headings;
  const int nearest = lattice.nearestHeading(stem.pose.yaw);
  const int to_either_side = !stem.turns ? 0 : stem.is_end ? count / 2 : kHeadingsTried;
  std::vector<int> headings;
  for (int k = -to_either_side; k <= to_either_side; ++k) headings.push_back((nearest + k + count) % count);
  return headings;
}

std::vector<Spur> spursOf(const Lattice& lattice, const Keep& keep, const std::vector<Stem>& stems,
                          bool is_goal) {
  std::vector<Spur> spurs;
  for (const Stem& stem : stems)
    for (const int heading : headingsOf(lattice, stem))
      for (Spur& spur : snapped(lattice, keep, stem.gait, stem.pose, heading, is_goal)) {
        spur.route.insert(is_goal ? spur.route.end() : spur.route.begin(), stem.route.begin(),
                          stem.route.end());
        spur.cost = totalCost(lattice.checker().robot(), lattice.settings().policy, spur.route);
        spurs.push_back(std::move(spur));
      }
  return spurs;
}

}  // namespace

std::vector<Spur> waysFromStart(const Lattice& lattice, const Keep& keep, const Request& request) {
  return spursOf(lattice, keep, stemsOf(lattice, keep, request.start_mode, request.start, false), false);
}

std::vector<Spur> waysToGoal(const Lattice& lattice, const Keep& keep, const Request& request) {
  const Point at = request.goal;
  std::vector<Stem> stems;
  if (request.goal_yaw) {
    stems = stemsOf(lattice, keep, request.goal_mode, {at.x, at.y, *request.goal_yaw}, true);
  } else {
    for (int k = 0; k < lattice.settings().headings; ++k)
      for (Stem& stem : stemsOf(lattice, keep, request.goal_mode, {at.x, at.y, lattice.yawOf(k)}, true)) {
        stem.turns = false;
        stems.push_back(std::move(stem));
      }
  }
  return spursOf(lattice, keep, stems, true);
}

}  // namespace underway::bench
