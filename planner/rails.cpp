#include "planner/rails.hpp"

#include <algorithm>
#include <cmath>

#include "planner/plan.hpp"

namespace underway {
namespace {

constexpr double kLongest_m = 12.0;  // looked at to either side of a pose
constexpr double kStep_m = 0.05;     // between looks along a line
constexpr double kExact_m = 1e-4;    // to which the end of a free stretch is found
// A second way through keeps this much more from what it goes under than the margin, for those who want it
// safest.
constexpr double kRoom_m = kEnoughClearance_m;
constexpr double kRoomStep_m = 0.1;  // between looks for room to turn
constexpr double kRoomAway_m = 1.5;  // how far to look for it

/// Halves an interval until the last free position before a blocked one is known to kExact_m.
template <class IsFree>
double lastFree(double free_m, double blocked_m, const IsFree& is_free) {
  while (std::abs(blocked_m - free_m) > kExact_m) {
    const double middle = 0.5 * (free_m + blocked_m);
    (is_free(middle) ? free_m : blocked_m) = middle;
  }
  return free_m;
}

}  // namespace

/// A straight line through a pose of a mode, measured from it along a sense [m].
struct Rails::Line {
  ModeId mode;
  Sense sense;
  Pose origin;

  [[nodiscard]] Pose at(double along_m) const {
    const double direction = origin.yaw + angleOf(sense);
    return {origin.x + along_m * std::cos(direction), origin.y + along_m * std::sin(direction), origin.yaw};
  }
  /// The line's heading, bit for bit, for a pose that has it but for rounding.
  [[nodiscard]] Pose onIt(const Pose& pose) const { return {pose.x, pose.y, origin.yaw}; }
};

double Rails::freeWay(const Line& line, double direction, double most_m) const {
  const Sense sense = direction > 0.0 ? line.sense : opposite(line.sense);
  const auto is_free = [&](double way) {
    return checker_.isFree(translate(line.mode, sense, line.origin, way));
  };
  return is_free(most_m) ? most_m : lastFree(0.0, most_m, is_free);
}

bool Rails::isFreeAt(const Line& line, const Switch& change, double along_m) const {
  const Pose pose = line.at(along_m);
  return checker_.isFree(
      switchModes(change, change.to == line.mode ? before(pose, change.displacement) : pose));
}

std::optional<double> Rails::nextFree(const Line& line, const Switch& change, double from_m, double direction,
                                      double most_m) const {
  bool was_blocked = false;
  for (double away = 0.0; away <= most_m; away += kStep_m) {
    const double along = from_m + direction * away;
    if (!isFreeAt(line, change, along)) {
      was_blocked = true;
    } else if (was_blocked) {
      return lastFree(along, along - direction * kStep_m,
                      [&](double at) { return isFreeAt(line, change, at); });
    }
  }
  return std::nullopt;
}

Rails::PlaceId Rails::addEnd(ModeId mode, const Pose& pose, double direction, std::vector<PlaceId>& waiting) {
  const double margin = checker_.robot().margin_m;
  const PlaceId place = sites_.add(mode, pose.position(), margin);
  waiting.push_back(place);
  const Mode& moving = checker_.robot().modes[mode];
  if (!moving.canTurn() || (!moving.canMove(Sense::kForward) && !moving.canMove(Sense::kBackward)))
    return place;
  for (double away = 0.0; away <= kRoomAway_m; away += kRoomStep_m) {
    const Motion step = translate(mode, direction > 0.0 ? Sense::kForward : Sense::kBackward, pose, away);
    if (!checker_.isFreeAllRound(mode, step.to.position(), margin)) continue;
    if (away == 0.0 || !checker_.isFree(step)) return place;
    waiting.push_back(sites_.add(mode, step.to.position(), margin));
    sites_.connect(place, waiting.back());
    return place;
  }
  return place;
}

void Rails::addPassage(const Line& line, const Switch& down, const Switch& up, double entry_m, double exit_m,
                       std::vector<PlaceId>& waiting) {
  const Pose standing = before(line.at(entry_m), down.displacement);
  Motion entry = switchModes(down, standing);
  entry.to = line.onIt(entry.to);
  const Motion crawl = translate(line.mode, line.sense, entry.to, exit_m - entry_m);
  if (!checker_.isFree(crawl)) return;
  const Motion exit = switchModes(up, crawl.to);
  const PlaceId from = addEnd(down.from, standing, -1.0, waiting);
  const PlaceId to = addEnd(up.to, exit.to, 1.0, waiting);
  draft_.addCrossing(from, to, Crossing(checker_.robot(), {entry, crawl, exit}));
}

std::vector<Rails::PlaceId> Rails::addThrough(ModeId mode, Sense sense, const Pose& pose) {
  const Line line{mode, sense, pose};
  const double behind = freeWay(line, -1.0, kLongest_m);
  const double ahead = freeWay(line, 1.0, kLongest_m);
  std::vector<PlaceId> waiting;
  for (const Switch& down : checker_.robot().switches) {
    if (down.to != mode) continue;
    const auto entry = nextFree(line, down, 0.0, -1.0, behind);
    if (!entry) continue;
    for (const Switch& up : checker_.robot().switches) {
      if (up.from != mode) continue;
      const auto exit = nextFree(line, up, 0.0, 1.0, ahead);
      if (!exit) continue;
      addPassage(line, down, up, *entry, *exit, waiting);
      if (isFreeAt(line, down, *entry - kRoom_m) && isFreeAt(line, up, *exit + kRoom_m))
        addPassage(line, down, up, *entry - kRoom_m, *exit + kRoom_m, waiting);
    }
  }
  return waiting;
}

std::vector<Rails::PlaceId> Rails::addExits(PlaceId place, ModeId mode, Sense sense, const Pose& pose,
                                            const Route& lead_in) {
  const Line line{mode, sense, pose};
  const double ahead = freeWay(line, 1.0, kLongest_m);
  std::vector<PlaceId> waiting;
  for (const Switch& up : checker_.robot().switches) {
    if (up.from != line.mode) continue;
    const auto exit = nextFree(line, up, 0.0, 1.0, ahead);
    if (!exit) continue;
    const Motion crawl = translate(line.mode, sense, pose, *exit);
    if (!isFreeKeeping(checker_, crawl, draft_.place(place).keep_m)) continue;
    Route motions = lead_in;
    motions.push_back(crawl);
    motions.push_back(switchModes(up, crawl.to));
    const PlaceId to = addEnd(up.to, motions.back().to, 1.0, waiting);
    draft_.addCrossing(place, to, Crossing(checker_.robot(), std::move(motions)));
  }
  return waiting;
}

std::vector<Rails::PlaceId> Rails::addEntries(PlaceId place, ModeId mode, Sense sense, const Pose& pose,
                                              const Route& lead_out) {
  const Line line{mode, sense, pose};
  const double behind = freeWay(line, -1.0, kLongest_m);
  std::vector<PlaceId> waiting;
  for (const Switch& down : checker_.robot().switches) {
    if (down.to != line.mode) continue;
    const auto entry = nextFree(line, down, 0.0, -1.0, behind);
    if (!entry) continue;
    const Pose standing = before(line.at(*entry), down.displacement);
    Motion change = switchModes(down, standing);
    change.to = line.onIt(change.to);
    const Motion crawl = translate(line.mode, sense, change.to, pose.position());
    if (!isFreeKeeping(checker_, crawl, draft_.place(place).keep_m)) continue;
    Route motions{change, crawl};
    motions.insert(motions.end(), lead_out.begin(), lead_out.end());
    draft_.addCrossing(addEnd(down.from, standing, -1.0, waiting), place,
                       Crossing(checker_.robot(), std::move(motions)));
  }
  return waiting;
}

std::vector<Rails::PlaceId> Rails::addNarrow(ModeId mode, Sense sense, const Pose& pose) {
  const Line line{mode, sense, pose};
  const double margin = checker_.robot().margin_m;
  const PlaceId middle = sites_.add(mode, pose.position(), margin);
  std::vector<PlaceId> waiting{middle};
  for (const double direction : {-1.0, 1.0}) {
    const double end = freeWay(line, direction, kRoomAway_m);
    double away = kRoomStep_m;
    while (away < end && !checker_.isFreeAllRound(mode, line.at(direction * away).position(), margin))
      away += kRoomStep_m;
    if (std::min(away, end) < kExact_m) continue;
    const Sense along = direction > 0.0 ? sense : opposite(sense);
    waiting.push_back(
        sites_.add(mode, translate(mode, along, pose, std::min(away, end)).to.position(), margin));
    sites_.connect(middle, waiting.back());
  }
  return waiting;
}

std::vector<Rails::PlaceId> Rails::addWayOut(PlaceId place, ModeId mode, Sense sense, const Pose& pose) {
  const double margin = checker_.robot().margin_m;
  const auto is_free = [&](double way) {
    return isFreeKeeping(checker_, translate(mode, sense, pose, way), draft_.place(place).keep_m);
  };
  double away = kRoomStep_m;
  while (away < kRoomAway_m && is_free(away)) {
    if (checker_.isFreeAllRound(mode, translate(mode, sense, pose, away).to.position(), margin)) break;
    away += kRoomStep_m;
  }
  if (!is_free(away)) away = lastFree(0.0, away, is_free);
  const Motion step = translate(mode, sense, pose, away);
  // Further on the margin holds again, or this is no way out.
  if (away < kExact_m || !checker_.isFree(stay(mode, step.to))) return {};
  const PlaceId out = sites_.add(mode, step.to.position(), margin);
  sites_.connect(place, out);
  return {out};
}

std::vector<std::size_t> overhangsFor(const World& world, const Robot& robot, ModeId mode) {
  const double low = world.floorZ() + robot.modes[mode].body_m.z.max;
  const double step = world.floorZ() + robot.modes[mode].step_over_m;
  double high = low;
  for (const Mode& other : robot.modes) high = std::max(high, world.floorZ() + other.body_m.z.max);
  std::vector<std::size_t> overhangs;
  for (std::size_t i = 0; i < world.obstacles().size(); ++i) {
    const OrientedBox& box = world.obstacles()[i].box;
    const auto vertices = corners(box);
    const auto [lowest, highest] = std::minmax_element(
        vertices.begin(), vertices.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    const bool hangs = lowest->z > low && lowest->z <= high;
    const bool leans =
        (box.rpy_rad.x != 0.0 || box.rpy_rad.y != 0.0) && highest->z > low && lowest->z <= high;
    const bool is_stepped_over = highest->z < step && highest->z > world.floorZ();
    if (hangs || leans || is_stepped_over) overhangs.push_back(i);
  }
  return overhangs;
}

}  // namespace underway
