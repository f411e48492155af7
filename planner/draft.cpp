#include "planner/draft.hpp"

#include <algorithm>
#include <cmath>

#include "planner/freezer.hpp"

namespace underway {

Draft::Draft(const Robot& robot, std::shared_ptr<const Roadmap> base)
    : robot_(robot),
      base_(std::move(base)),
      first_own_(base_ ? static_cast<PlaceId>(base_->places.size()) : 0) {}

Draft::PlaceId Draft::addPlace(ModeId mode, Point at, double keep_m) {
  own_.push_back({Roadmap::Place{at, mode, keep_m, 0, 0}, {}, placeCount()});
  return placeCount() - 1;
}

void Draft::keepLess(PlaceId place, double keep_m) {
  double& keep = own_[place - first_own_].place.keep_m;
  keep = std::min(keep, keep_m);
}

std::vector<double>& Draft::headingsOf(PlaceId place) {
  return place < first_own_ ? base_headings_[place] : own_[place - first_own_].headings;
}

void Draft::addHeading(PlaceId place, double yaw) {
  std::vector<double>& headings = headingsOf(place);
  if (std::find(headings.begin(), headings.end(), yaw) == headings.end()) headings.push_back(yaw);
}

void Draft::addTranslation(PlaceId a, PlaceId b, double yaw, Sense sense) {
  const Mode& mode = robot_.modes[modeOf(a)];
  if (mode.canMove(sense)) addLink({MotionKind::kTranslate, a, b, yaw, yaw, sense});
  if (mode.canMove(opposite(sense))) addLink({MotionKind::kTranslate, b, a, yaw, yaw, opposite(sense)});
  addHeading(a, yaw);
  addHeading(b, yaw);
}

void Draft::addSwitch(PlaceId from, double from_yaw, PlaceId to, double to_yaw) {
  addLink({MotionKind::kSwitch, from, to, from_yaw, to_yaw, Sense::kForward});
  addHeading(from, from_yaw);
  addHeading(to, to_yaw);
}

void Draft::addTwins(PlaceId first, PlaceId second) {
  twins_.emplace_back(first, second);
  join(first, second);
}

void Draft::addLink(const Link& link) {
  links_.push_back(link);
  join(link.from, link.to);
}

void Draft::join(PlaceId a, PlaceId b) {
  if (a < first_own_ || b < first_own_) return;  // the base's places are joined as they are
  own_[rootOf(a) - first_own_].parent = rootOf(b);
}

Draft::PlaceId Draft::rootOf(PlaceId place) {
  const auto parent = [&](PlaceId of) -> PlaceId& { return own_[of - first_own_].parent; };
  while (parent(place) != place)
    place = parent(place) = parent(parent(place));  // halves the way for the next time
  return place;
}

std::optional<double> Draft::headingNear(PlaceId place, double yaw, double tolerance_rad) const {
  const auto is_near = [&](double heading) {
    return std::abs(normalizedAngle(heading - yaw)) <= tolerance_rad;
  };
  const auto find_in = [&](const std::vector<double>& headings) -> std::optional<double> {
    const auto found = std::find_if(headings.begin(), headings.end(), is_near);
    return found == headings.end() ? std::nullopt : std::optional(*found);
  };
  if (place >= first_own_) return find_in(own_[place - first_own_].headings);
  const Roadmap::Place& frozen = base_->places[place];
  for (Roadmap::NodeId node = frozen.first_node; node < frozen.end_node; ++node)
    if (is_near(base_->nodes[node].pose.yaw)) return base_->nodes[node].pose.yaw;
  const auto added = base_headings_.find(place);
  return added == base_headings_.end() ? std::nullopt : find_in(added->second);
}

std::optional<Roadmap> Draft::freeze(const Checker& checker, Check check, Interrupt& interrupt) const {
  return Freezer(*this, checker, check, interrupt).freeze();
}

}  // namespace underway
