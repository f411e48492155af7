#include "local/surroundings.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "geometry/sweep.hpp"
#include "local/lane.hpp"
#include "local/low.hpp"
#include "local/seen_from.hpp"

namespace underway {
namespace {

constexpr std::size_t kMostPoints = 2048;
constexpr double kMargin_m = 0.005;  // from what is unmapped; the nearest of many noisy beams adds to it
/// From the outlines of what was seen before: they and the belief are off by some millimetres.
constexpr double kRemembered_m = 0.025;
constexpr double kRememberedLeast_m = 0.01;  // from each point for itself, however near others are
/// From what the map has, where it was seen: it may stand some centimetres from where the map has it, and the
/// belief is off by a centimetre. Plans pass as close by as they say.
constexpr Range kMapped_m{0.01, 0.025};
constexpr double kClose_m = 1.0;    // so near to that is looked at
constexpr double kGuarded_m = 1.0;  // what is further away cannot be run into in a tick

Tolerance toleranceOf(const SurroundingsSettings& settings) {
  Tolerance tolerance;
  tolerance.near_m = 0.025 + 2.0 * settings.sensor_sigma_m;
  return tolerance;
}

/// From each point of that for itself, however near others are. Outlines are off by more where noise is.
double leastFromMapped(const SurroundingsSettings& settings) { return 0.015 - settings.sensor_sigma_m; }

/// Of the standing body, in any direction [m/s].
double fastestOf(const Robot& robot) {
  const SpeedLimits limits = standingLimits(robot);
  return std::hypot(std::max(limits.forward_mps, limits.backward_mps),
                    std::max(limits.left_mps, limits.right_mps));
}

Guard guardOf(const Robot& robot, GuardSettings settings) {
  settings.fastest_mps = fastestOf(robot);
  return {settings, robot.modes.front().body_m, kMostPoints};
}

bool isAlongX(Sense sense) { return sense == Sense::kForward || sense == Sense::kBackward; }

/// The shifts of a lane that are tried, one after the other: none, 5 cm to the left, to the right, 10 cm.
struct Shifts {
  static constexpr double kStep_m = 0.05;
  static constexpr std::size_t kMost = 41;
  [[nodiscard]] static std::size_t countTo(double most_m) {
    return most_m < kStep_m ? 1 : std::min(1 + 2 * static_cast<std::size_t>(most_m / kStep_m), kMost);
  }
  [[nodiscard]] static double shift(std::size_t i) {
    const std::size_t steps = (i + 1) / 2;
    const double size = kStep_m * static_cast<double>(steps);
    return i % 2 == 1 ? size : -size;
  }
};

}  // namespace

Surroundings::Surroundings(const SurroundingsSettings& settings, std::shared_ptr<const Robot> robot)
    : settings_(settings),
      robot_(std::move(robot)),
      against_unmapped_(guardOf(*robot_, {kMargin_m, 1.0})),
      against_remembered_(guardOf(*robot_, {kRemembered_m, 1.0, kRememberedLeast_m})),
      against_unseen_(guardOf(*robot_, {kUnseen_m, 1.0})),
      against_mapped_(guardOf(*robot_, {kMapped_m.max, 0.5, leastFromMapped(settings)})),
      reach_m_(reachOf(robot_->modes.front().body_m) + kRemembered_m + fastestOf(*robot_)) {}

void Surroundings::expect(const World& map, const Plan& plan) {
  if (robot_->senses.waist) {
    const double height = robot_->senses.waist->height_m;
    waist_map_ = MapView(map, {height, height}, plan, toleranceOf(settings_), settings_.round_m);
  }
  if (robot_->senses.head) {
    const double height = robot_->senses.head->height_m;
    head_map_ = MapView(map, {height, height}, plan, toleranceOf(settings_), settings_.round_m);
  }
  if (robot_->senses.depth)
    depth_map_ = MapView(map, {0.02, robot_->modes.front().body_m.z.max}, plan, toleranceOf(settings_),
                         settings_.round_m);
}

void Surroundings::passBy(double clearance_m) {
  against_mapped_.keep(std::clamp(clearance_m / 3.0, kMapped_m.min, kMapped_m.max));
}

void Surroundings::see(const Senses& senses, const Pose& from) {
  against_unmapped_.clear();
  against_remembered_.clear();
  against_unseen_.clear();
  against_mapped_.clear();
  window_.slideTo(from.position());
  mapped_.slideTo(from.position());
  floor_.slideTo(from.position());
  ++turn_;
  const bool is_lying = isLow(*robot_, senses.mode);
  const bool is_steady = !senses.is_switching && !senses.has_fallen;  // else its planes are anywhere
  const bool has_plane = is_lying ? robot_->senses.head.has_value() : robot_->senses.waist.has_value();
  if (is_steady && has_plane && senses.scan != nullptr)
    look(*senses.scan, is_lying ? head_map_ : waist_map_, from);
  if (is_steady && senses.depth != nullptr) look(*senses.depth, depth_map_, from);
  standOn(robot_->modes[senses.mode].body_m, from);
  addWhatWasSeen(from);
  if (!is_lying) addUnseenFloor(from);
}

/// What was seen before: no beam may look there now.
void Surroundings::addWhatWasSeen(const Pose& from) {
  const SeenFrom seen(from);
  const double sigma_m = settings_.sensor_sigma_m;
  window_.visitOutlines(from.position(), reach_m_, sigma_m,
                        [&](Point at) { against_remembered_.add(seen(at)); });
  mapped_.visitOutlines(from.position(), reach_m_, sigma_m, [&](Point at) { against_mapped_.add(seen(at)); });
}

void Surroundings::look(const Scan& scan, const MapView& map, const Pose& from) {
  // A plane that passes below a table top must not take back what a depth camera saw of it.
  if (!robot_->senses.depth || &map == &depth_map_) takeBack(scan, from);
  constexpr std::size_t kPart = 4;  // of the beams that end on mapped things, in a tick
  const SeenFrom seen(from);
  forEachBeam(scan.beams, from.yaw, [&](std::size_t i, Point direction) {
    const double range = scan.ranges_m[i];
    if (!(range < settings_.believed_m)) return;
    const Point end{from.x + range * direction.x, from.y + range * direction.y};
    if (map.isExpected(end, range)) {
      if (range < kClose_m && i % kPart == turn_ % kPart) mapped_.hit(end);
      return;
    }
    window_.hit(end);
    if (range < kGuarded_m) against_unmapped_.add(seen(end));
  });
}

/// Nothing stands where beams pass. Each tick some of them are looked at for floor that was seen, and others
/// the next.
void Surroundings::takeBack(const Scan& scan, const Pose& from) {
  window_.takeBack(scan, from, settings_.believed_m);
  mapped_.takeBack(scan, from, kClose_m);
  constexpr std::size_t kShare = 16;
  const std::size_t first = turn_ % kShare;
  forEachBeam(scan.beams.every(kShare, first), from.yaw, [&](std::size_t i, Point direction) {
    const float range = scan.ranges_m[first + kShare * i];
    if (range == Scan::kNotLooked) return;
    const double reach = std::min<double>(range, settings_.believed_m);
    floor_.pass(from.position(), {from.x + reach * direction.x, from.y + reach * direction.y});
  });
}

/// Calls `visit(left_m)` for each cell that no plan knew of beside a stretch of a translation, and beside the
/// body at its end: how far to the left of its line. What is further off than `reach_m` may be left out.
template <class Visit>
void Surroundings::visitBeside(const Motion& translation, Range along, double reach_m,
                               const Visit& visit) const {
  const BodyBox& body = robot_->modes[translation.mode].body_m;
  const Range size = isAlongX(translation.sense) ? body.x : body.y;
  const double last = along.max + std::max(-size.min, size.max) + settings_.lane_margin_m;
  const Point middle = pointAlong(translation, 0.5 * (along.min + last));
  const SeenFrom seen(
      {translation.from.x, translation.from.y, translation.from.yaw + angleOf(translation.sense)});
  window_.visitOccupied(middle, 0.5 * (last - along.min) + reach_m, [&](Point cell, bool is_known) {
    if (is_known) return;
    const Point at = seen(cell);
    if (at.x > along.min && at.x < last) visit(at.y);
  });
}

Range Surroundings::nextStretch(const Motion& translation, double along_m) const {
  return {along_m, std::min(along_m + settings_.ahead_m, length(translation))};
}

double Surroundings::halfLane(const Motion& translation) const {
  const BodyBox& body = robot_->modes[translation.mode].body_m;
  const Range across = isAlongX(translation.sense) ? body.y : body.x;
  return std::max(-across.min, across.max) + settings_.lane_margin_m;
}

bool Surroundings::isBlockedAlong(const Motion& translation, Range along) const {
  const double half = halfLane(translation);
  bool is_blocked = false;
  visitBeside(translation, along, half, [&](double left_m) { is_blocked |= std::abs(left_m) < half; });
  return is_blocked;
}

bool Surroundings::isLaneBlocked(const Motion& translation, double along_m) const {
  return isBlockedAlong(translation, nextStretch(translation, along_m));
}

bool Surroundings::isWholeLaneBlocked(const Motion& translation) const {
  return isBlockedAlong(translation, {0.0, length(translation)});
}

bool Surroundings::isTurnBlocked(const Pose& at) const {
  const double reach = reachOf(robot_->modes.front().body_m);
  bool is_blocked = false;
  window_.visitOccupied(at.position(), reach + Window::kCell_m, [&](Point cell, bool is_known) {
    is_blocked |= !is_known && distance(cell, at.position()) < reach;
  });
  return is_blocked;
}

bool Surroundings::isBoxBlocked(const BodyBox& box, const Pose& at) const {
  const SeenFrom seen(at);
  const Range x = box.x.grown(settings_.lane_margin_m);
  const Range y = box.y.grown(settings_.lane_margin_m);
  bool is_blocked = false;
  window_.visitOccupied(at.position(), reachOf(box) + Window::kCell_m, [&](Point cell, bool is_known) {
    if (is_known) return;
    const Point local = seen(cell);
    is_blocked |= local.x > x.min && local.x < x.max && local.y > y.min && local.y < y.max;
  });
  return is_blocked;
}

std::optional<double> Surroundings::shiftAround(const Motion& translation, double along_m,
                                                double most_m) const {
  const double half = halfLane(translation);
  const std::size_t count = Shifts::countTo(most_m);
  std::bitset<Shifts::kMost> blocked;
  const Range along = nextStretch(translation, along_m);
  visitBeside(translation, along, half + std::max(most_m, 0.0), [&](double left_m) {
    for (std::size_t i = 0; i < count; ++i)
      if (std::abs(left_m - Shifts::shift(i)) < half) blocked.set(i);
  });
  for (std::size_t i = 0; i < count; ++i)
    if (!blocked[i]) return Shifts::shift(i);
  return std::nullopt;
}

Velocity Surroundings::guarded(const Velocity& wanted) const {
  return allowedByAll({&against_unmapped_, &against_remembered_, &against_unseen_, &against_mapped_}, wanted);
}

std::vector<Point> Surroundings::surprisesNear(Point at, double reach_m) const {
  std::vector<Point> cells;
  window_.visitOccupied(at, reach_m, [&](Point cell, bool) { cells.push_back(cell); });
  return cells;
}

}  // namespace underway
