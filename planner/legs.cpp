#include "planner/legs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "planner/roadmap.hpp"

namespace underway {
namespace {

/// Whether one body lies within another.
bool isWithin(const BodyBox& inner, const BodyBox& outer) {
  const auto within = [](const Range& a, const Range& b) { return a.min >= b.min && a.max <= b.max; };
  return within(inner.x, outer.x) && within(inner.y, outer.y) && within(inner.z, outer.z);
}

/// Whether a body turned by half a revolution covers the same ground.
bool isSymmetric(const BodyBox& body) { return body.x.min == -body.x.max && body.y.min == -body.y.max; }

}  // namespace

Legs::Legs(const Checker& checker, Policy policy, double at_least_m, std::vector<ModeId> companions)
    : checker_(checker),
      robot_(checker.robot()),
      mode_count_(robot_.modes.size()),
      policy_(policy),
      at_least_m_(at_least_m),
      companions_(std::move(companions)),
      changes_(robot_.modes.size() * robot_.modes.size()) {
  for (const ModeId mode : companions_)
    for (const Sense sense : kSenses)  // without turning no leg leads from one stop to another
      if (robot_.modes[mode].canTurn() && robot_.modes[mode].canMove(sense))
        ways_.push_back({mode, sense, angleOf(sense), 1e6 / robot_.modes[mode].speed(sense)});
  for (std::size_t way = 0; way < ways_.size(); ++way) {
    std::size_t same = 0;
    while (!coverTheSame(ways_[same], ways_[way])) ++same;
    same_sweep_.push_back(same);
    const auto back = std::find_if(ways_.begin(), ways_.end(), [&](const Way& other) {
      return other.mode == ways_[way].mode && other.sense == underway::opposite(ways_[way].sense);
    });
    opposite_.push_back(back == ways_.end() ? std::nullopt
                                            : std::optional<std::size_t>(back - ways_.begin()));
  }
  by_cost_.resize(ways_.size());
  std::iota(by_cost_.begin(), by_cost_.end(), std::size_t{0});
  std::sort(by_cost_.begin(), by_cost_.end(), [&](std::size_t a, std::size_t b) {
    const Cost cost_a = legCost(ways_[a], 1.0);
    const Cost cost_b = legCost(ways_[b], 1.0);
    return cost_a < cost_b || (cost_a == cost_b && a < b);
  });
  for (const ModeId from : companions_)
    for (const ModeId to : companions_) changes_[from * robot_.modes.size() + to] = changeBetween(from, to);
  for (const ModeId from : companions_)
    for (const ModeId to : companions_) {
      const Mode& a = robot_.modes[from];
      const Mode& b = robot_.modes[to];
      are_alike_ &= a.body_m == b.body_m && a.step_over_m == b.step_over_m &&
                    changes_[from * robot_.modes.size() + to].is_covered;
      if (const Cost cost = changeCost({0.0, from}, {std::numbers::pi, to}); cost != Cost::most())
        dearest_ = std::max(dearest_, cost);
    }
}

Cost Legs::cheapestShortLeg(std::uint32_t ways, double length_m) const {
  Cost least = Cost::most();
  for (std::size_t way = 0; ways >> way != 0; ++way)
    if ((ways >> way & 1U) != 0) least = std::min(least, legCost(ways_[way], length_m));
  return least;
}

Cost Legs::cheapestLeg(double length_m) const {
  return ways_.empty() ? Cost() : cheapestLeg((1U << ways_.size()) - 1U, length_m);
}

bool Legs::coverTheSame(const Way& a, const Way& b) const {
  const Mode& mode = robot_.modes[a.mode];
  const Mode& other = robot_.modes[b.mode];
  if (!(mode.body_m == other.body_m) || mode.drift_m_per_m != other.drift_m_per_m ||
      mode.step_over_m != other.step_over_m)
    return false;
  const double turned = std::abs(normalizedAngle(a.angle_rad - b.angle_rad));
  return turned == 0.0 || (turned > 3.0 && underway::isSymmetric(mode.body_m));
}

bool Legs::isSymmetric(std::size_t way) const {
  return underway::isSymmetric(robot_.modes[ways_[way].mode].body_m);
}

bool Legs::has(ModeId mode) const {
  return std::find(companions_.begin(), companions_.end(), mode) != companions_.end();
}

Legs::Change Legs::changeBetween(ModeId from, ModeId to) const {
  std::vector<std::optional<Change>> best(robot_.modes.size());
  best[from] = Change{};
  for (std::size_t round = 0; round < companions_.size(); ++round) {  // Bellman and Ford over few modes
    for (const Switch& change : robot_.switches) {
      if (!has(change.from) || !has(change.to) || !(change.displacement == Pose{}) || !best[change.from])
        continue;
      Change next = *best[change.from];
      next.via.push_back(change.to);
      next.cost = next.cost + costOf(robot_, policy_, switchModes(change, {}));
      if (!best[change.to] || next.cost < best[change.to]->cost) best[change.to] = next;
    }
  }
  if (!best[to]) return {{}, Cost::most(), 0.0, true, false};
  Change result = *best[to];
  result.turns_first = robot_.modes[from].turn_speed_radps >= robot_.modes[to].turn_speed_radps;
  const double speed = robot_.modes[result.turns_first ? from : to].turn_speed_radps;
  result.us_per_rad = speed > 0.0 ? 1e6 / speed : 0.0;
  ModeId before = from;
  for (const ModeId next : result.via) {
    const Switch& change = *robot_.findSwitch(before, next);
    result.is_covered &= isCoveredBy(change, from) || isCoveredBy(change, to);
    before = next;
  }
  return result;
}

bool Legs::isCoveredBy(const Switch& change, ModeId mode) const {
  const double seen_m = std::min(robot_.modes[change.from].step_over_m, robot_.modes[change.to].step_over_m);
  return isWithin(change.body_m, robot_.modes[mode].body_m) && robot_.modes[mode].step_over_m <= seen_m;
}

double Legs::clearanceFor(double keep_m) const {
  return keep_m < robot_.margin_m ? keep_m : std::max(keep_m, at_least_m_);
}

bool Legs::isFree(const Motion& motion, double keep_m) const {
  return isFreeKeeping(checker_, motion, clearanceFor(keep_m));
}

bool Legs::isLegFree(const Way& way, Point from, Point to, double yaw, double keep_m) const {
  return isFree(translate(way.mode, way.sense, {from.x, from.y, yaw}, to), keep_m);
}

std::optional<Route> Legs::changeBy(Point at, const Stance& from, const Stance& to, double angle_rad,
                                    double keep_m) const {
  const Change& change = changes_[from.mode * robot_.modes.size() + to.mode];
  Route route;
  Pose here{at.x, at.y, from.yaw};
  ModeId mode = from.mode;
  const auto turn_here = [&] {
    if (std::abs(angle_rad) <= kSameYaw_rad) return true;
    route.push_back(turn(mode, here, angle_rad, to.yaw));
    here.yaw = to.yaw;
    return isFree(route.back(), keep_m);
  };
  if (change.turns_first && !turn_here()) return std::nullopt;
  for (const ModeId next : change.via) {
    route.push_back(switchModes(*robot_.findSwitch(mode, next), here));
    mode = next;
    if (!change.is_covered && !isFree(route.back(), keep_m)) return std::nullopt;
  }
  if (!change.turns_first && !turn_here()) return std::nullopt;
  return route;
}

std::optional<Route> Legs::change(Point at, const Stance& from, const Stance& to, double keep_m) const {
  if (changeCost(from, to) == Cost::most()) return std::nullopt;
  const double angle = normalizedAngle(to.yaw - from.yaw);
  if (auto route = changeBy(at, from, to, angle, keep_m)) return route;
  if (std::abs(angle) <= kSameYaw_rad) return std::nullopt;
  const double other_way = angle - std::copysign(2.0 * std::numbers::pi, angle);
  return changeBy(at, from, to, other_way, keep_m);
}

bool Legs::isChangeFree(Point at, const Stance& from, const Stance& to, double keep_m) const {
  const Change& change = changes_[from.mode * robot_.modes.size() + to.mode];
  const double angle = normalizedAngle(to.yaw - from.yaw);
  if (!change.is_covered) return changeBy(at, from, to, angle, keep_m).has_value();
  if (std::abs(angle) <= kSameYaw_rad) return true;
  return isFree(turn(change.turns_first ? from.mode : to.mode, {at.x, at.y, from.yaw}, angle, to.yaw),
                keep_m);
}

bool Legs::turnsFreely(Point at, double keep_m) const {
  return are_alike_ && checker_.isFreeAllRound(companions_[0], at, clearanceFor(keep_m));
}

TurningRoom Legs::roomAt(Point at, const Stance& stance, double keep_m) const {
  if (!are_alike_ || keep_m < robot_.margin_m) return {};
  const Pose pose{at.x, at.y, stance.yaw};
  // Where a start has less room than is asked for, what can be turned from there means nothing.
  if (at_least_m_ > robot_.margin_m && !isFree(stay(stance.mode, pose), keep_m)) return {};
  return checker_.turningRoom(stance.mode, pose, clearanceFor(keep_m));
}

Cost Legs::freeChangeCost(Point at, const Stance& from, const TurningRoom& room, const Stance& to,
                          double keep_m) const {
  if (!are_alike_ || keep_m < robot_.margin_m) return freeChangeCost(at, from, to, keep_m);
  const Cost cost = changeCost(from, to);
  const double angle = normalizedAngle(to.yaw - from.yaw);
  if (cost == Cost::most() || std::abs(angle) <= kSameYaw_rad) return cost;
  const double same_way = angle > 0.0 ? room.left_rad : room.right_rad;
  if (std::abs(angle) <= same_way) return cost;
  const double long_way = 2.0 * std::numbers::pi - std::abs(angle);
  if (long_way > (angle > 0.0 ? room.right_rad : room.left_rad)) return Cost::most();
  const Change& change = changes_[from.mode * robot_.modes.size() + to.mode];
  return change.cost + Cost::time(1 + static_cast<std::uint64_t>(long_way * change.us_per_rad));
}

Cost Legs::freeChangeCost(Point at, const Stance& from, const Stance& to, double keep_m) const {
  const Cost cost = changeCost(from, to);
  if (cost == Cost::most() || isChangeFree(at, from, to, keep_m)) return cost;
  const auto route = change(at, from, to, keep_m);
  return route ? costOf(robot_, policy_, *route) : Cost::most();
}

}  // namespace underway
