#include "planner/shorten.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planner/draft.hpp"
#include "planner/rails.hpp"
#include "planner/search.hpp"
#include "planner/sites.hpp"

namespace underway {
namespace {

using PlaceId = Draft::PlaceId;

constexpr double kStep_m = 0.5;    // between points along a translation
constexpr std::size_t kReach = 6;  // points ahead that each point is connected to; corners to all corners
constexpr std::array kShifts_m{0.12, 0.04, 0.015};  // how far corners are moved, round by round

/// A position on the route or close to it, with its places.
struct Stop {
  std::vector<PlaceId> places;  // in the route's mode there first, then its companions
  std::size_t corner;           // number of the last corner up to here
  std::size_t leg;  // only stops of one leg are connected: a leg ends where a switch moves the robot
  bool is_corner;   // where motions meet; the others lie between
};

class Shortcuts {
 public:
  Shortcuts(const Checker& checker, Policy policy, const Route& route, const Keeping& keeping, double shift_m)
      : checker_(checker),
        robot_(checker.robot()),
        policy_(policy),
        route_(route),
        keeping_(keeping),
        shift_m_(shift_m),
        draft_(robot_),
        sites_(checker, draft_, Draft::Check::kWhenUsed),
        rails_(checker, draft_, sites_) {
    for (const Motion& motion : route)
      if (motion.kind == MotionKind::kTranslate) {
        lowest_mode_ = std::max(lowest_mode_, motion.mode);
        is_used_[motion.mode] = true;
      }
  }

  Route best(Interrupt& interrupt) {
    layOut();
    connect();
    const auto roadmap = draft_.freeze(checker_, Draft::Check::kWhenUsed, interrupt);
    if (!roadmap) return route_;
    Target target{*findNode(*roadmap, stops_.front().places[0], route_.front().from.yaw), here_, std::nullopt,
                  policy_, keeping_.at_least_m};
    if (!keeping_.any_heading) target.goal_node = findNode(*roadmap, here_, route_.back().to.yaw);
    EdgeChecks checks(*roadmap, checker_);
    auto found = search(*roadmap, robot_, checks, target, interrupt);
    if (!found) return route_;
    return std::move(*found);
  }

 private:
  /// Puts the route itself into the draft, motion by motion, with points along it and round its corners.
  void layOut() {
    here_ = addCorner(route_.front().mode, route_.front().from.position(), keeping_.start_m);
    draft_.addHeading(here_, route_.front().from.yaw);
    // What follows the last change of position is turning at the goal.
    const auto moves = [](const Motion& m) { return m.from.position() != m.to.position(); };
    const auto last = std::find_if(route_.rbegin(), route_.rend(), moves).base();
    for (auto motion = route_.begin(); motion != route_.end(); ++motion)
      layOut(*motion, motion + 1 >= last ? keeping_.goal_m : robot_.margin_m);
    draft_.addHeading(here_, route_.back().to.yaw);
  }

  void layOut(const Motion& motion, double keep_m) {
    switch (motion.kind) {
      case MotionKind::kTurn:
        draft_.addHeading(here_, motion.from.yaw);
        draft_.addHeading(here_, motion.to.yaw);
        break;
      case MotionKind::kTranslate:
        translate(motion, keep_m);
        break;
      case MotionKind::kSwitch:
        changeMode(motion, keep_m);
        break;
    }
  }

  void translate(const Motion& motion, double keep_m) {
    const bool can_turn = robot_.modes[motion.mode].canTurn();
    if (can_turn && shift_m_ == 0.0) addPointsAlong(motion);
    const PlaceId next = addCorner(motion.mode, motion.to.position(), keep_m);
    if (can_turn && shift_m_ > 0.0) addPointsRound(motion.mode, motion.to.position());
    if (!can_turn && shift_m_ > 0.0) addLinesBeside(motion);
    draft_.addTranslation(here_, next, motion.from.yaw, motion.sense);
    here_ = next;
  }

  void changeMode(const Motion& motion, double keep_m) {
    if (motion.from == motion.to) {
      const auto& places = cornerAt(here_).places;
      const auto twin = std::find_if(places.begin(), places.end(),
                                     [&](PlaceId p) { return draft_.modeOf(p) == motion.to_mode; });
      if (twin != places.end()) {
        draft_.addSwitch(here_, motion.from.yaw, *twin, motion.to.yaw);
        here_ = *twin;
        return;
      }
    }
    const PlaceId from = here_;
    ++leg_;
    here_ = addCorner(motion.to_mode, motion.to.position(), keep_m);
    draft_.addSwitch(from, motion.from.yaw, here_, motion.to.yaw);
  }

  [[nodiscard]] const Stop& cornerAt(PlaceId place) const {
    return *std::find_if(stops_.rbegin(), stops_.rend(), [&](const Stop& stop) {
      return std::find(stop.places.begin(), stop.places.end(), place) != stop.places.end();
    });
  }

  PlaceId addCorner(ModeId mode, Point at, double keep_m) {
    stops_.push_back({sites_.add(mode, at, keep_m), ++corner_, leg_, true});
    return stops_.back().places[0];
  }

  void addPoint(ModeId mode, Point at) {
    stops_.push_back({sites_.add(mode, at, robot_.margin_m), corner_, leg_, false});
  }

  void addPointsAlong(const Motion& motion) {
    const double way = length(motion);
    const auto count = static_cast<int>(way / kStep_m);
    for (int i = 1; i <= count; ++i)
      addPoint(
          motion.mode,
          underway::translate(motion.mode, motion.sense, motion.from, way * i / (count + 1)).to.position());
  }

  void addPointsRound(ModeId mode, Point at) {
    for (int i = 0; i < 8; ++i) {
      const double angle = i * std::numbers::pi / 4.0;
      addPoint(mode, {at.x + shift_m_ * std::cos(angle), at.y + shift_m_ * std::sin(angle)});
    }
  }

  /// A mode that cannot turn has its whole line moved to either side.
  void addLinesBeside(const Motion& motion) {
    const bool along_x = motion.sense == Sense::kForward || motion.sense == Sense::kBackward;
    for (const double aside : {-3.0 * shift_m_, -shift_m_, shift_m_, 3.0 * shift_m_}) {
      const Pose moved = compose(motion.from, along_x ? Pose{0.0, aside, 0.0} : Pose{aside, 0.0, 0.0});
      if (!checker_.isFree(stay(motion.mode, moved))) continue;
      const auto waiting = rails_.addThrough(motion.mode, motion.sense, moved);
      beside_.insert(beside_.end(), waiting.begin(), waiting.end());
    }
  }

  void connect() {
    for (const PlaceId place : beside_)
      for (const Stop& stop : stops_)
        if (stop.is_corner) connect({{place}, 0, 0, false}, stop);
    for (std::size_t i = 0; i < stops_.size(); ++i)
      for (std::size_t j = i + 1; j < stops_.size() && stops_[j].leg == stops_[i].leg; ++j)
        if (areToConnect(i, j)) connect(stops_[i], stops_[j]);
  }

  [[nodiscard]] bool areToConnect(std::size_t i, std::size_t j) const {
    if (shift_m_ > 0.0) return stops_[j].corner == stops_[i].corner + 1;
    return j - i <= kReach || (stops_[i].is_corner && stops_[j].is_corner);
  }

  void connect(const Stop& a, const Stop& b) {
    for (const PlaceId p : a.places)
      for (const PlaceId q : b.places)
        if (draft_.modeOf(p) == draft_.modeOf(q) && mayHelp(draft_.modeOf(p))) sites_.connect(p, q);
  }

  /// Moved corners stay in the modes the route uses, and by priority a mode lower than those only makes it
  /// worse.
  [[nodiscard]] bool mayHelp(ModeId mode) const {
    if (!robot_.modes[mode].canTurn()) return false;
    if (shift_m_ > 0.0) return is_used_[mode];
    return policy_ != Policy::kPriority || mode <= lowest_mode_;
  }

  const Checker& checker_;
  const Robot& robot_;
  Policy policy_;
  const Route& route_;
  const Keeping& keeping_;
  double shift_m_;  // 0: connect the route's own points; else: try its corners moved by this
  Draft draft_;
  Sites sites_;
  Rails rails_;
  std::vector<PlaceId>
      beside_;  // places at the ends of lines beside the route's, to be connected to every corner
  ModeId lowest_mode_ = 0;
  std::array<bool, kMaxModes> is_used_{};
  std::vector<Stop> stops_;
  std::size_t leg_ = 0;
  std::size_t corner_ = 0;
  PlaceId here_ = 0;
};

}  // namespace

Route shortened(const Checker& checker, Policy policy, Route route, const Keeping& keeping,
                Interrupt& interrupt) {
  route = joined(checker, route);
  const auto improve = [&](double shift_m) {
    if (route.empty() || interrupt.isDueNow()) return;
    Route next = joined(checker, Shortcuts(checker, policy, route, keeping, shift_m).best(interrupt));
    if (costOf(checker.robot(), policy, next) < costOf(checker.robot(), policy, route))
      route = std::move(next);
  };
  improve(0.0);
  for (const double shift_m : kShifts_m) improve(shift_m);
  return route;
}

}  // namespace underway
