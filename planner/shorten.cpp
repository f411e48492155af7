#include "planner/shorten.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planner/corridor.hpp"
#include "planner/movable.hpp"
#include "planner/nudge.hpp"

namespace underway {
namespace {

/// By how much stops and crossings are moved, round by round.
constexpr std::array kCoarse_m{0.4, 0.2, 0.08};
constexpr std::array kFine_m{0.02, 0.004};
constexpr std::array kWidening_m{0.2, 0.08, 0.03, 0.01};  // tried in turn, until one step leads to a way
constexpr std::size_t kReach = 6;  // stations ahead that legs lead to, when stops are to be left out
constexpr std::size_t kStopsRound = 8;
constexpr double kSamePoint_m = 1e-6;
constexpr double kNearCorner = 1.6;  // steps from an end of a leg to where its corner may be cut
constexpr double kMostOfLeg = 0.4;   // to there

/// A route divided into stops and crossings, and improved as a whole.
class Shortening {
 public:
  Shortening(const Checker& checker, const Stances& stances, Passage passage, const Keeping& keeping)
      : robot_(checker.robot()),
        stances_(stances),
        crossings_{&checker, stances.policy(), stances.atLeast(), keeping.start_m, keeping.goal_m, false,
                   false},
        passage_(std::move(passage)),
        goal_(passage_.goal) {}

  Passage best(Interrupt& interrupt) {
    // Only so many stations are left out at a time, so again until none is.
    while (improve(withStopsLeftOut(), interrupt)) continue;
    for (const double step_m : kCoarse_m) {
      nudge(step_m, interrupt);
      if (!goesAside()) continue;
      improve(withMoves(step_m), interrupt);
      improve(withStopsLeftOut(), interrupt);
    }
    return polished(interrupt);
  }

  std::optional<Passage> widened(Interrupt& interrupt) {
    for (const double step_m : kWidening_m)
      if (auto wider = cheapestThrough(withMoves(step_m), Cost::most(), interrupt)) {
        passage_ = std::move(*wider);
        return result();
      }
    return std::nullopt;
  }

  Passage polished(Interrupt& interrupt) {
    for (const double step_m : kFine_m) nudge(step_m, interrupt);
    return result();
  }

 private:
  bool improve(const Corridor& corridor, Interrupt& interrupt) {
    auto better = cheapestThrough(corridor, passage_.cost, interrupt);
    if (!better) return false;
    passage_ = std::move(*better);
    return true;
  }

  void nudge(double step_m, Interrupt& interrupt) {
    Nudge nudge(crossings_, std::move(passage_));
    nudge.by(step_m, interrupt);
    passage_ = std::move(nudge).passage();
  }

  /// Whether a leg costs more than any time that may be saved elsewhere: then all that can be tried is.
  [[nodiscard]] bool goesAside() const {
    return std::any_of(passage_.steps.begin(), passage_.steps.end(),
                       [&](const Passage::Step& step) { return isAside(stances_.policy(), step); });
  }

  Passage result() {
    passage_.goal = goal_;
    return std::move(passage_);
  }

  // --- corridors round the passage ------------------------------------------------------------------------

  /// The passage itself, of which stops may be left out.
  [[nodiscard]] Corridor withStopsLeftOut() const {
    Corridor corridor;
    for (const Passage::Step& step : passage_.steps) {
      Station station;
      station.options = {step.option};
      station.may_be_skipped = step.option.is_stop;
      station.reach = kReach;
      station.legs_on = &stances_.ofMode(step.leaving.mode);
      corridor.push_back(std::move(station));
    }
    return corridor;
  }

  /// Stops and crossings moved by a step, and stops added, all at the same time and with any ways between.
  /// Crossings may not be free as they are.
  [[nodiscard]] Corridor withMoves(double step_m) const {
    Corridor corridor;
    for (std::size_t i = 0; i < passage_.steps.size(); ++i) {
      const Passage::Step& step = passage_.steps[i];
      if (step.way) addBetween(i, step_m, corridor);
      Station station;
      station.options = {step.option};
      station.reach = 2;
      station.legs_on = &stances_.ofMode(step.leaving.mode);
      const bool is_end = i == 0 || i + 1 == passage_.steps.size();
      if (step.option.is_stop) addStopsRound(step.option, step_m, station);
      if (!is_end && !step.option.is_stop) {
        if (!movable(i).isFree()) station.options.clear();
        addCrossingsBeside(i, step_m, station);
      }
      corridor.push_back(std::move(station));
    }
    return corridor;
  }

  void addStopsRound(const Option& stop, double step_m, Station& station) const {
    for (std::size_t i = 0; i < kStopsRound; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kStopsRound;
      station.options.push_back(Option::stop(
          {stop.in.x + step_m * std::cos(angle), stop.in.y + step_m * std::sin(angle)}, robot_.margin_m));
    }
  }

  [[nodiscard]] Movable movable(std::size_t i) const {
    return {crossings_.at(passage_.steps, i), passage_.steps[i].option.motions};
  }

  void addCrossingsBeside(std::size_t i, double step_m, Station& station) const {
    const Movable crossing = movable(i);
    for (const Movable::Move move : Movable::kMoves) {
      const auto moved = crossing.moved(move, step_m);
      if (moved && moved->isFree()) station.options.push_back(moved->option());
    }
  }

  void addBetween(std::size_t i, double step_m, Corridor& corridor) const {
    const Passage::Step& a = passage_.steps[i - 1];
    Station station;
    station.may_be_skipped = true;
    station.reach = 2;
    station.legs_on = &stances_.ofMode(a.leaving.mode);
    const Point from = a.option.out.position();
    const Point to = passage_.steps[i].option.in.position();
    std::vector<Point> points = stopsBetween(passage_.steps, i);
    if (const double share = kNearCorner * step_m / distance(from, to); share < kMostOfLeg) {
      points.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
      points.push_back({to.x + share * (from.x - to.x), to.y + share * (from.y - to.y)});
    }
    for (const Point at : points)
      if (distance(from, at) > kSamePoint_m && distance(at, to) > kSamePoint_m)
        station.options.push_back(Option::stop(at, robot_.margin_m));
    if (!station.options.empty()) corridor.push_back(std::move(station));
  }

  const Robot& robot_;
  const Stances& stances_;
  Movable::Rules crossings_;
  Passage passage_;
  std::size_t goal_;  // that it leads to
};

/// A passage that another policy has made, with this one's legs and costs. That of the whole is left to who
/// improves it.
Passage measuredBy(const Checker& checker, const Stances& stances, Passage passage) {
  for (Passage::Step& step : passage.steps) {
    if (step.legs) step.legs = &stances.ofMode(step.arriving.mode);
    step.option.cost = costOf(checker.robot(), stances.policy(), step.option.motions);
  }
  return passage;
}

}  // namespace

Passage shortened(const Checker& checker, const Stances& stances, Passage passage, const Keeping& keeping,
                  Interrupt& interrupt) {
  return Shortening(checker, stances, measuredBy(checker, stances, std::move(passage)), keeping)
      .best(interrupt);
}

Passage polished(const Checker& checker, const Stances& stances, Passage passage, const Keeping& keeping,
                 Interrupt& interrupt) {
  return Shortening(checker, stances, measuredBy(checker, stances, std::move(passage)), keeping)
      .polished(interrupt);
}

std::optional<Passage> widened(const Checker& checker, const Stances& stances, Passage passage,
                               const Keeping& keeping, Interrupt& interrupt) {
  return Shortening(checker, stances, measuredBy(checker, stances, std::move(passage)), keeping)
      .widened(interrupt);
}

}  // namespace underway
