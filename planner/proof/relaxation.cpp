#include "planner/proof/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace underway::proof {
namespace {

constexpr double kPi = std::numbers::pi;
// How near the goal a plan may end (formats: 'Plan'), and a little.
constexpr double kGoal_m = 0.01 + 1e-6;
constexpr double kGoal_rad = 0.02 + 1e-6;
constexpr double kHair_rad = 1e-6;  // that a step may lie off its sense's axis

/// The cosine at all angles within `half` of one.
Range cosines(double middle, double half) {
  const double off = std::abs(normalizedAngle(middle));  // cos is even, and falls from 0 to pi
  return {off + half >= kPi ? -1.0 : std::cos(off + half), off <= half ? 1.0 : std::cos(off - half)};
}

CellBox boxOf(const Grid& grid, const Goal& asked) {
  const Pose goal = grid.inCorner({asked.at.x, asked.at.y, asked.yaw.value_or(0.0)});
  const Range yaw = asked.yaw ? Range{goal.yaw, goal.yaw}.grown(kGoal_rad) : Range{0.0, 2.0 * kPi};
  return grid.boxAround(Range{goal.x, goal.x}.grown(kGoal_m), Range{goal.y, goal.y}.grown(kGoal_m), yaw);
}

bool touch(const CellBox& cell, const CellBox& box) {
  const auto meet = [](UnitRange a, UnitRange b) { return a.low <= b.high && b.low <= a.high; };
  if (!meet(cell[kX], box[kX]) || !meet(cell[kY], box[kY])) return false;
  const auto turned = [&](Units by) { return UnitRange{box[kYaw].low + by, box[kYaw].high + by}; };
  return meet(cell[kYaw], turned(0)) || meet(cell[kYaw], turned(kWholeAxis)) ||
         meet(cell[kYaw], turned(-kWholeAxis));
}

}  // namespace

Relaxation::Relaxation(const Checker& checker, const Request& request, double margin_m, Interrupt& interrupt)
    : stances_(stancesOf(checker, margin_m)),
      survey_(checker, stances_, interrupt),
      start_(survey_.grid().inCorner(request.start)),
      start_stance_(stances_.of_mode[request.start_mode]) {
  for (const Goal& goal : goalsOf(request))
    goals_.push_back({stances_.of_mode[goal.mode], boxOf(survey_.grid(), goal)});
  for (std::size_t s = 0; s < stances_.all.size(); ++s) {
    const Footprint& body = stances_.shapes[stances_.all[s].shape].footprint;
    reach_m_.push_back(std::hypot(std::max(-body.x.min, body.x.max), std::max(-body.y.min, body.y.max)));
    floors_.push_back({CellTree(stances_.all[s].can_turn), {}, {}});
    for (CellId cell = 0; cell < cells(s).size(); ++cell) {
      floors_[s].extents_m.push_back(measured({static_cast<std::uint32_t>(s), cell}));
      for (std::size_t slot = 0; slot < slots(s); ++slot)
        floors_[s].outlooks.push_back(survey_.look(shapeOf(s, slot), cells(s).box(cell), interrupt));
    }
  }
  findStarts();
}

void Relaxation::findStarts() {
  const auto at = [](double value) { return Range{value, value}; };
  std::vector<CellId> found;
  cells(start_stance_)
      .findTouching(survey_.grid().boxAround(at(start_.x), at(start_.y), at(start_.yaw)), found);
  starts_.clear();
  for (const CellId cell : found) starts_.push_back({start_stance_, cell});
}

std::size_t Relaxation::size() const {
  std::size_t count = 0;
  for (const Floor& floor : floors_) count += floor.cells.size();
  return count;
}

double Relaxation::measured(const Place& place) const {
  const auto extent = survey_.grid().extentOf(cells(place.stance).box(place.cell));
  return std::max({extent.x_m, extent.y_m, 0.5 * extent.yaw_rad * reach_m_[place.stance]});
}

std::size_t Relaxation::longestAxis(const Place& place) const {
  const auto extent = survey_.grid().extentOf(cells(place.stance).box(place.cell));
  const double yaw = extent.yaw_rad * reach_m_[place.stance];
  if (yaw > extent.x_m && yaw > extent.y_m) return kYaw;
  return extent.x_m > extent.y_m ? kX : kY;
}

bool Relaxation::isGoal(const Place& place) const {
  const CellBox& cell = cells(place.stance).box(place.cell);
  return std::any_of(goals_.begin(), goals_.end(),
                     [&](const End& goal) { return goal.stance == place.stance && touch(cell, goal.box); });
}

bool Relaxation::leadsTo(const Place& from, CellId neighbour) const {
  const CellBox& a = cells(from.stance).box(from.cell);
  const CellBox& b = cells(from.stance).box(neighbour);
  const Contact contact = contactOf(a, b);
  // Across yaw only a stance that turns has neighbours.
  if (contact.axis == kYaw || stance(from).senses.size() == kSenses.size()) return true;
  const CellBox common{UnitRange{}, UnitRange{},
                       UnitRange{std::max(a[kYaw].low, b[kYaw].low), std::min(a[kYaw].high, b[kYaw].high)}};
  const auto headings = survey_.grid().extentOf(common);
  const double across = (contact.axis == kY ? 0.5 * kPi : 0.0) + (contact.is_upwards ? 0.0 : kPi);
  return std::any_of(stance(from).senses.begin(), stance(from).senses.end(), [&](Sense sense) {
    const double off = std::abs(normalizedAngle(headings.middle.yaw + angleOf(sense) - across));
    return off < 0.5 * kPi + headings.yaw_rad + kHair_rad;
  });
}

void Relaxation::findBeyond(const Place& from, std::size_t exit, std::vector<CellId>& found) const {
  const Exit& out = stance(from).exits[exit];
  const auto extent = survey_.grid().extentOf(cells(from.stance).box(from.cell));
  const auto [dx, dy, turned] = out.displacement;
  const double far = std::hypot(dx, dy);
  const double direction = std::atan2(dy, dx) + extent.middle.yaw;
  const Range along_x = cosines(direction, extent.yaw_rad);
  const Range along_y = cosines(direction - 0.5 * kPi, extent.yaw_rad);
  const auto [x, y, yaw] = extent.middle;
  const double new_yaw = yaw + std::remainder(turned, 2.0 * kPi);
  cells(out.to).findTouching(
      survey_.grid().boxAround({x - extent.x_m + far * along_x.min, x + extent.x_m + far * along_x.max},
                               {y - extent.y_m + far * along_y.min, y + extent.y_m + far * along_y.max},
                               {new_yaw - extent.yaw_rad, new_yaw + extent.yaw_rad}),
      found);
}

CellId Relaxation::split(const Place& place, std::size_t axis, Interrupt& interrupt) {
  Floor& floor = floors_[place.stance];
  const std::size_t count = slots(place.stance);
  const CellId upper = floor.cells.split(place.cell, axis);
  floor.extents_m.push_back(floor.extents_m[place.cell] = measured(place));
  floor.outlooks.resize(floor.outlooks.size() + count);
  for (std::size_t slot = 0; slot < count; ++slot) {
    const Outlook before = outlook(place, slot);
    for (const CellId half : {place.cell, upper}) {
      Outlook& after = floor.outlooks[half * count + slot];
      after = before.state == Outlook::State::kUndecided
                  ? survey_.lookAgain(shapeOf(place.stance, slot), floor.cells.box(half), before, interrupt)
                  : before;  // what holds at all poses of a cell holds at those of its halves
    }
  }
  if (std::find(starts_.begin(), starts_.end(), place) != starts_.end()) findStarts();
  return upper;
}

void Relaxation::lift(std::span<const std::size_t> obstacles, std::optional<std::size_t> shape,
                      Interrupt& interrupt) {
  for (std::size_t s = 0; s < stances_.shapes.size(); ++s)
    for (const std::size_t obstacle : obstacles)
      if (!shape || *shape == s) survey_.lift(s, obstacle);
  for (std::size_t s = 0; s < floors_.size(); ++s) {
    for (std::size_t i = 0; i < floors_[s].outlooks.size() && !interrupt.isDue(); ++i) {
      Outlook& known = floors_[s].outlooks[i];
      const std::size_t seen_by = shapeOf(s, i % slots(s));
      if (survey_.mayTouchLifted(seen_by, known))
        known = survey_.lookAgain(seen_by, cells(s).box(static_cast<CellId>(i / slots(s))), known, interrupt);
    }
  }
}

std::vector<std::size_t> Relaxation::blockersOfBody(const Place& place) {
  return survey_.blockersOf(stance(place).shape, cells(place.stance).box(place.cell), ofBody(place));
}

std::vector<std::size_t> Relaxation::blockersOfExit(const Place& place, std::size_t exit) {
  return survey_.blockersOf(stance(place).exits[exit].shape, cells(place.stance).box(place.cell),
                            ofExit(place, exit));
}

}  // namespace underway::proof
